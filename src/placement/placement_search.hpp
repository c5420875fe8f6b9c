#pragma once

#include <optional>

#include "placement/placement_trials.hpp"

namespace wristwise {

struct PlacementSearch {
  std::optional<Placement> best;  ///< none where there was no time
  ObstacleCounts counts;
};

/// The least measure in the region: global searches from several starts, each followed by a local
/// one. The same result with any number of threads.
PlacementSearch search_region(PlacementTrials& trials, const PlacementOptions& options,
                              int threads);

/// Local search from a placement, along some of the coordinates.
PlacementSearch search_nearby(PlacementTrials& trials, const PlacementOptions& options,
                              const Placement& start, const std::vector<int>& coordinates);

}  // namespace wristwise
