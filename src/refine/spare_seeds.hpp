#pragma once

#include <functional>
#include <vector>

#include "refine/refinement.hpp"
#include "wristwise/options.hpp"

namespace wristwise {

/// Whether stage 1 may be asked for more seeds where none can be refined: it can give more than
/// one, and its first search was a cheap one, since each further path costs about as much.
bool may_try_spare_seeds(const GraphOptions& options, const GraphStatistics& first_search);

/// Refines what the search for more seeds finds beside those that were tried without success.
/// @param best what stage 2 made of `tried`
/// @param tried gets the others at its end
/// @param find all seeds, those tried among them; @param refine tells each what became of it
/// @return the best of all
Refined try_spare_seeds(Refined best, std::vector<Seed>& tried,
                        const std::function<std::vector<Seed>()>& find,
                        const std::function<Refined(std::vector<Seed>&)>& refine);

}  // namespace wristwise
