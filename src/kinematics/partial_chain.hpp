#pragma once

#include <vector>

#include "wristwise/robot.hpp"

namespace wristwise {

/// From the frame before a joint to its own: its origin and its motion (F5).
Pose joint_transform(const Joint& joint, double position);

/// The chain with some joints held where `posture` has them.
/// @param held by index, increasing; not all joints
/// @param posture one value per joint, rad or m; used where a joint is held
Robot with_held_joints(const Robot& robot, const std::vector<int>& held,
                       const JointVector& posture);

}  // namespace wristwise
