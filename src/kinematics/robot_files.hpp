#pragma once

#include <filesystem>
#include <vector>

#include "wristwise/urdf.hpp"

namespace wristwise {

/// The files that load_robot reads for a source that it accepts: the description, the limits, the
/// SRDF, the meshes of links.
std::vector<std::filesystem::path> robot_files(const RobotSource& source);

}  // namespace wristwise
