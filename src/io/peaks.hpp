#pragma once

#include <optional>

#include "wristwise/robot.hpp"
#include "wristwise/trajectory.hpp"

namespace wristwise {

/// For each joint, the largest divided difference of this order (1 velocity, 2 acceleration,
/// 3 jerk) by its size; nullopt where the path has too few points.
std::optional<JointVector> peak_derivative(const JointPath& path, int order);

/// Likewise of a curve, for all t.
JointVector peak_derivative(const Trajectory& trajectory, int order);

/// The limits of the derivative of this order.
JointVector derivative_limits(const Robot& robot, int order);

}  // namespace wristwise
