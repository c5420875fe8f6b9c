#pragma once

#include <string>
#include <vector>

#include "wristwise/robot.hpp"
#include "wristwise/seam.hpp"

// What is claimed about the speed of the seam; one line for each claim that does not hold.
namespace wristwise {

/// Why a time law can't be one of the task's seam: it runs back, or does not cover the seam.
std::vector<std::string> law_failures(const Task& task, const Trajectory& seam_time);

/// Where the seam runs faster than the problem's, or slower than that allows.
/// @param prescribed as the problem says  @param run the same under another time law
std::vector<std::string> pace_failures(const Task& prescribed, const Task& run);

/// Joints that are not at rest at an end at which the task asks for that.
std::vector<std::string> rest_failures(const Task& task, const Robot& robot,
                                       const Trajectory& trajectory);

}  // namespace wristwise
