#pragma once

#include <optional>
#include <vector>

#include "wristwise/robot.hpp"
#include "wristwise/trajectory.hpp"

namespace wristwise {

/// How finely a curve is cut into straight joint-space moves.
struct PointChoice {
  double max_deviation = 0;        ///< m
  double max_angle_deviation = 0;  ///< rad
  std::optional<double> period;    ///< s; given: the deviations do not count
  double resolution = 0;           ///< s between the times that are points or may be
};

struct ChosenPoints {
  std::vector<double> times;  ///< s, increasing, both ends of the curve among them
  double deviation = 0, angle_deviation = 0;
};

/// The fewest points, each chosen as far as possible from the one before it, between which
/// straight moves at constant joint rates keep the TCP within the deviation of where the curve has
/// it, looked at every half resolution.
/// @param keep times (s) that are points in any case, inside the curve, increasing
ChosenPoints choose_points(const Robot& robot, const Trajectory& curve,
                           const std::vector<double>& keep, const PointChoice& choice);

}  // namespace wristwise
