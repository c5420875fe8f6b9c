#pragma once

#include <string>

#include "wristwise/robot_program.hpp"

namespace wristwise {

/// The weld goes on, or off, at the point: it differs before and after.
bool weld_starts_at(const RobotProgram& program, std::size_t point);
bool weld_ends_at(const RobotProgram& program, std::size_t point);

/// How many points, how far from the curve: for a comment.
std::string points_comment(const RobotProgram& program);

}  // namespace wristwise
