#pragma once

#include <optional>

#include "graph/distinct_paths.hpp"
#include "graph/path_sampling.hpp"
#include "wristwise/plan.hpp"

namespace wristwise {

/// What stage 1 found.
struct GraphPlan {
  bool found = false;
  std::vector<Seed> seeds;  ///< the best first; where nothing was found, its best part
  GraphStatistics statistics;
  std::optional<Diagnosis> diagnosis;
};

/// Stage 1: samples -> rungs -> paths. @param timing sampling and search are added to
GraphPlan plan_graph(const SamplingInput& input, const Task& task, double epsilon, int threads,
                     const Monitor& monitor, Timing& timing);

}  // namespace wristwise
