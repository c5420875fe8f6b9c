#pragma once

#include <string>

#include "picture/motion_picture.hpp"

namespace wristwise {

/// How the tolerance is used over time, coordinate by coordinate, as SVG. At the left the deviation
/// in mm or deg with the edges of the box; at the right its share: -1 and 1 are the edges, at a
/// coordinate without a width what holds between waypoints. A free angle has no share.
std::string tolerance_svg(const MotionPicture& motions);

}  // namespace wristwise
