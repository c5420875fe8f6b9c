#pragma once

#include <string>

#include "wristwise/placement.hpp"

namespace wristwise {

/// The map as SVG: the measure in colours with their scale, hatched where nothing can be welded,
/// the given and the found placement marked. Empty where there is no map.
std::string placement_map_svg(const PlacementResult& result, const std::string& title);

}  // namespace wristwise
