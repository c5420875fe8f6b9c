#pragma once

#include "wristwise/robot.hpp"

namespace wristwise {

/// How fast the distance of two shapes can change per joint, for every posture inside the limits
/// (F9); zero for joints that move both or neither.
/// @param shape_a fixed to joint `joint_a` (-1: the base), its pose in that joint's frame
JointVector motion_radius(const Robot& robot, int joint_a, const Shape& shape_a, int joint_b,
                          const Shape& shape_b);

}  // namespace wristwise
