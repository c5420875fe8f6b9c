#pragma once

#include <cstddef>
#include <vector>

#include "wristwise/robot.hpp"

namespace wristwise {

/// Moves a posture near a solution onto it: Newton steps, and Levenberg-Marquardt steps where the
/// chain is near a singular posture.
/// @return whether the TCP is within 1e-12 m and 1e-12 rad of the target
bool polish_posture(const Robot& robot, const Pose& target, JointVector& q);

/// Polishes a start and appends it, angles in (-pi, pi], unless it fails or is there already, from
/// branch `first` on.
void append_polished(const Robot& robot, const Pose& target, JointVector start, std::size_t first,
                     std::vector<JointVector>& branches);

}  // namespace wristwise
