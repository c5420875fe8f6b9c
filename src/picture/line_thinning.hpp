#pragma once

#include <vector>

#include "picture/svg.hpp"

namespace wristwise {

/// A line with fewer points that looks the same: x ascends, everything in pixels.
///
/// Of the points in a column of pixels as wide as `column` those at the left, at the right, lowest
/// and highest stay, so that peaks keep their heights; then points within 0.1 pixels above or below
/// the line between points that stay are left out. The ends stay.
std::vector<SvgPoint> thinned(const std::vector<SvgPoint>& line, double column = 1);

}  // namespace wristwise
