#pragma once

#include <vector>

#include "graph/graph_search.hpp"

namespace wristwise {

struct FinerPath {
  LadderPath path;
  int rounds = 0;  ///< searches
};

/// Coarse to fine: samples again around the postures of a path, on a grid of half the step, until
/// the cost settles (F21). The path never becomes dearer.
FinerPath refine_grid(GraphSearch& search, const SamplingInput& input, const Task& task,
                      LadderPath path, int threads);

}  // namespace wristwise
