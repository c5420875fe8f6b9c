#pragma once

#include "wristwise/robot.hpp"

namespace wristwise {

/// Moves a posture near a solution onto it: Newton steps, and Levenberg-Marquardt steps where the
/// chain is near a singular posture.
/// @return whether the TCP is within 1e-12 m and 1e-12 rad of the target
bool polish_posture(const Robot& robot, const Pose& target, JointVector& q);

}  // namespace wristwise
