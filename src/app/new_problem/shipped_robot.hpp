#pragma once

#include <filesystem>

namespace wristwise::app {

/// The URDF of the robot that a new problem is for where none is named: in the folder robots/ of
/// the source that the program was built in, or of share/wristwise beside its bin/.
/// @throws InvalidInput where there is none, which asks for --robot.
std::filesystem::path shipped_robot();

}  // namespace wristwise::app
