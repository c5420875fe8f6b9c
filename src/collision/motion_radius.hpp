#pragma once

#include "wristwise/robot.hpp"

namespace wristwise {

/// How fast the distance of two shapes can change per joint, for every posture inside the limits
/// (F9); zero for joints that move both or neither.
/// @param shape_a fixed to joint `joint_a` (-1: the base), its pose in that joint's frame
JointVector motion_radius(const Robot& robot, int joint_a, const Shape& shape_a, int joint_b,
                          const Shape& shape_b);

/// How far a point of a shape, fixed to joint `far`, can be from the axis of each joint after
/// `near`, for every posture inside the limits; 1 for prismatic joints, 0 for the others (F31).
JointVector reach_of(const Robot& robot, int far, const Shape& shape, int near);

}  // namespace wristwise
