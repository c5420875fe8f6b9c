#pragma once

#include <vector>

#include "graph/graph_search.hpp"

namespace wristwise {

struct SparsePath {
  LadderPath path;                  ///< at every waypoint; none where not found
  std::vector<std::size_t> points;  ///< waypoints that were planned
  int replans = 0;                  ///< searches after the first
  std::size_t postures = 0;         ///< on the rungs of the points
  std::size_t moves = 0;            ///< between waypoints that were checked
  std::size_t queries = 0;          ///< exact distance queries
};

/// Plans some of the waypoints and joins them by straight joint-space moves, projected into the
/// tolerance at the waypoints between; where that strays too far, collides or is too fast,
/// waypoints are added and the plan is made again (section II of De Maeyer et al., ETFA 2017; the
/// projection is Descartes' sparse planner's). Not the least-cost path, unless every waypoint is
/// needed.
SparsePath plan_sparse(const SamplingInput& input, const Task& task, double epsilon, int threads,
                       const Monitor& monitor);

}  // namespace wristwise
