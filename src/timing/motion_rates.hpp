#pragma once

#include <Eigen/Core>

#include "wristwise/robot.hpp"
#include "wristwise/trajectory.hpp"

namespace wristwise {

/// Velocity, acceleration and jerk of each joint: columns 0, 1 and 2.
using Rates = Eigen::Matrix<double, Eigen::Dynamic, 3, 0, kMaxJoints, 3>;

/// Of a motion at time t; at a time of its own, of the piece that begins there.
Rates rates_at(const Trajectory& motion, double t);

/// Limits of |rates|; infinity where there is none.
Rates rate_limits(const Robot& robot);

/// Of the motion q(tau(t)) from those of q(tau) and the derivatives 1 to 3 of tau(t) (F26).
Rates along_law(const Rates& motion, const Eigen::Vector3d& law);

/// outer(inner(t)) with the same value, velocity and acceleration at the times of `inner` (F26).
/// @pre inner has one joint, its values lie on `outer`
Trajectory run_along(const Trajectory& outer, const Trajectory& inner);

}  // namespace wristwise
