#pragma once

#include <string>

#include "picture/motion_picture.hpp"

namespace wristwise {

/// Position, velocity, acceleration and jerk of each joint over time as SVG, with their limits.
/// A limit that is far away is written, not drawn.
std::string joint_profiles_svg(const MotionPicture& motions);

}  // namespace wristwise
