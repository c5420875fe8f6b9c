#pragma once

#include "placement/placement_trials.hpp"

namespace wristwise {

/// The measure over the first two coordinates that are not fixed, through a placement; where the
/// time is over, samples are left unmeasured, with the obstacle "not_measured".
PlacementMap draw_map(PlacementTrials& trials, const PlacementOptions& options,
                      const Offset& through, int threads);

}  // namespace wristwise
