#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "wristwise/trajectory.hpp"

namespace wristwise {

bool is_ros_message(const std::filesystem::path& file);  ///< by its extension: .yaml, .yml

/// A JointTrajectory, or a RobotTrajectory with one in it, as ROS 1 or 2 prints it: its points.
/// @throws InvalidInput with file and line: a joint is missing, a number is not finite, times do
/// not increase, fewer than two points.
JointPath read_ros_message(const std::filesystem::path& file,
                           const std::vector<std::string>& joint_names);

}  // namespace wristwise
