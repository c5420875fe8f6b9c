#pragma once

#include <vector>

#include "refine/refinement.hpp"

namespace wristwise {

/// Refines every seed, in parallel, and returns the best: what holds every constraint before what
/// does not, then the least objective, then the earlier seed. Each seed is told what became of it.
/// A seed decides on which side of an obstacle the torch passes, and elbow, wrist and turns.
/// @throws Cancelled where the caller stops it before there is a motion that holds everything
Refined refine_seeds(const RefinementInput& input, std::vector<Seed>& seeds, int threads);

}  // namespace wristwise
