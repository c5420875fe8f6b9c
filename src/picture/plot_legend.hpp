#pragma once

#include <string>
#include <vector>

#include "picture/svg.hpp"

namespace wristwise {

/// A sign and what it means.
struct LegendEntry {
  enum class Sign { line, area };
  std::string name;
  Sign sign = Sign::line;
  std::string colour;
  std::string dash = {};
};

/// Draws the entries from left to right, in further lines where they would be wider than `width`.
/// @param y px, of the first base line
/// @return px, the height of all lines
double draw_legend(const std::vector<LegendEntry>& entries, double x, double y, double width,
                   SvgPicture& picture);

}  // namespace wristwise
