#pragma once

#include <filesystem>

#include "wristwise/export_options.hpp"
#include "wristwise/robot.hpp"
#include "wristwise/trajectory_file.hpp"
#include "wristwise/visibility.hpp"

namespace WRISTWISE_PUBLIC wristwise {

/// Reads a joint path by the file's extension: a robot program with joint moves (.src KUKA, .mod
/// and .prg ABB, .ls Fanuc), a JointTrajectory or RobotTrajectory of ROS (.yaml, .yml), or else a
/// trajectory.csv.
///
/// The first target of a program, the zero of a message's times, is at `start_time` (s); a CSV file
/// has times of its own. A move takes the time that the program
/// gives; else that of its TCP speed over the straight distance, but no less than a joint needs at
/// its limit; else that of the joint that needs longest at the program's percentage of its limit.
/// A move to where the robot is already and that has no time is left out.
/// @throws InvalidInput with file and line: what is not understood, a linear move, a target without
/// values for all joints; or as read_trajectory.
JointPath read_joint_path(const std::filesystem::path& file, const Robot& robot,
                          const ExportOptions& options, double start_time = 0);

}  // namespace wristwise
