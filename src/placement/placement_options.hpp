#pragma once

#include <vector>

#include "wristwise/placement.hpp"

namespace wristwise {

/// @throws InvalidInput for a region that is inverted or not finite, unknown objects, options out
/// of range, a request without its task.
void validate(const PlacementRequest& request);

/// The coordinates, 0 to 5, that are not fixed.
std::vector<int> free_coordinates(const PlacementOptions& options);

/// How many placements the search may measure.
int evaluation_limit(const PlacementOptions& options);

/// Whether the offset is inside the region.
bool is_inside(const PlacementOptions& options, const Offset& offset);

}  // namespace wristwise
