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

/// What to find out where there is no path.
enum class Help {
  always,         ///< what would help, and which pieces can be welded
  unless_speeds,  ///< the same, but not where moves are too fast for a joint
};

/// Stage 1: samples -> rungs -> paths. @param timing sampling and search are added to
GraphPlan plan_graph(const SamplingInput& input, const Task& task, double epsilon, int threads,
                     const Monitor& monitor, Timing& timing, Help help = Help::always);

/// Whether the diagnosis of a plan that found nothing counts moves that are too fast for a joint.
bool is_too_fast(const GraphPlan& plan);

}  // namespace wristwise
