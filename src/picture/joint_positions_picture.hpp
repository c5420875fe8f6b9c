#pragma once

#include <string>

#include "picture/motion_picture.hpp"

namespace wristwise {

/// The positions of all joints in one panel for each motion, as SVG: what is behind at the left,
/// the result at the right, to the same scale. Prismatic joints have panels of their own.
std::string joint_positions_svg(const MotionPicture& motions);

}  // namespace wristwise
