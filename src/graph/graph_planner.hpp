#pragma once

#include <optional>

#include "graph/distinct_paths.hpp"
#include "graph/path_sampling.hpp"
#include "wristwise/plan.hpp"

namespace wristwise {

/// What stage 1 found.
struct GraphPlan {
  bool found = false;
  bool too_fast = false;    ///< found for a lower speed only
  std::vector<Seed> seeds;  ///< the best first; where nothing was found, its best part
  GraphStatistics statistics;
  std::optional<Diagnosis> diagnosis;
};

/// What to do where there is no path because moves are too fast for a joint.
enum class Speed {
  hold,  ///< that is how it ends
  any,   ///< look for a path that the joints can follow at some lower speed, within reason
};

/// Stage 1: samples -> rungs -> paths. @param timing sampling and search are added to
GraphPlan plan_graph(const SamplingInput& input, const Task& task, double epsilon, int threads,
                     const Monitor& monitor, Timing& timing, Speed speed = Speed::hold);

}  // namespace wristwise
