#pragma once

#include "kinematics/deviation_cell.hpp"

namespace wristwise {

/// How a posture is led to its goal.
struct DescentRules {
  double length = 1;         ///< m that count as much as a radian on the way
  double tolerance = 1e-10;  ///< m and rad, of what counts as reached
  JointVector lower, upper;  ///< kept on the way; infinite where a joint is not held back
};

/// Moves a posture onto a pose by damped least squares (F71), for any number of joints: the nearest
/// solution, about, of those that a redundant chain has.
/// @return whether the TCP is within the tolerance of the pose. A start from which it does not get
/// there is given up after few steps.
bool descend_to_pose(const Robot& robot, const Pose& pose, const DescentRules& rules,
                     JointVector& q);

/// The same for the coordinates of a cell that have no width (F73), from a posture near the cell.
/// @return whether the TCP is in the cell, to the tolerance
bool polish_in_cell(const Robot& robot, const DeviationCell& cell, const DescentRules& rules,
                    JointVector& q);

}  // namespace wristwise
