#pragma once

#include <Eigen/Core>

#include "wristwise/visibility.hpp"

namespace WRISTWISE_PUBLIC wristwise {

/// The most movable joints a chain may have. Bounded, so that joint vectors live on the stack.
inline constexpr int kMaxJoints = 16;

/// One value for each movable joint, in chain order: rad for revolute, m for prismatic joints.
using JointVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMaxJoints, 1>;

/// 6 x n: rows 0-2 linear velocity (m/s), rows 3-5 angular velocity (rad/s), per unit joint speed.
using Jacobian = Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, kMaxJoints>;

/// 3 x n: linear velocity of a point per unit joint speed.
using PointJacobian = Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, kMaxJoints>;

}  // namespace wristwise
