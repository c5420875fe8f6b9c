#pragma once

#include <array>
#include <string>

#include "wristwise/robot.hpp"

namespace wristwise {

/// The axes of a six-axis arm at joint zero, in the base frame.
struct SixAxes {
  std::array<Eigen::Vector3d, 6> points;      ///< on each axis, m
  std::array<Eigen::Vector3d, 6> directions;  ///< unit
  Pose tcp;                                   ///< at joint zero
};

/// Tolerances of the closed forms that are polished.
constexpr double kRoundedNumbers = 1e-5;  ///< m or rad: of descriptions with 1.5708 for pi / 2
constexpr double kSlackOfStarts = 1e-4;   ///< how far out of reach a start may be; a share
constexpr double kDegenerateAxes = 1e-3;  ///< rad or m: too close for a usable arm

/// Why a chain has no six axes, or nothing.
std::string reason_for_no_six_axes(const Robot& robot);

/// The turn about axis j by an angle (rad), in the base frame.
Pose turn_about(const SixAxes& axes, std::size_t j, double angle);

/// @pre six revolute joints
SixAxes axes_at_zero(const Robot& robot);

/// Of two lines, whatever their sense: in [0, pi/2].
double line_angle(const Eigen::Vector3d& a, const Eigen::Vector3d& b);

/// Where axes come nearest to meeting.
struct Meeting {
  Eigen::Vector3d point;
  double distance = 0;  ///< m, from the axis that is farthest from it
};

/// Of axes first to last (by index, from 0).
Meeting meeting_of(const SixAxes& axes, std::size_t first, std::size_t last);

}  // namespace wristwise
