#pragma once

#include "kinematics/deviation_cell.hpp"

namespace wristwise {

/// Leads a posture to the nearest one, about, whose TCP is in the cell and whose joints are inside
/// the bounds (F73), by NLopt's sequential quadratic programme.
/// @return whether it came within 1e-6 m and rad: close enough to be polished
bool move_to_nearest_in_cell(const Robot& robot, const DeviationCell& cell,
                             const JointVector& lower, const JointVector& upper, JointVector& q);

}  // namespace wristwise
