#pragma once

#include <vector>

#include "graph/graph_search.hpp"

namespace wristwise {

struct DistinctPath {
  LadderPath path;
  std::size_t differs_at = 0;  ///< rung
};

/// The best paths that really differ: another branch of the robot, another side of an obstacle.
/// Each is the cheapest that on one of some rungs spread over the path keeps more than `separation`
/// (rad or m, of at least one joint, whole turns not counted) away from all that were found before.
/// @param best the least-cost path; it comes first
/// @return `count` paths, or fewer where there are no more
std::vector<DistinctPath> find_distinct_paths(GraphSearch& search, const std::vector<Rung>& rungs,
                                              const LadderPath& best, KnownChecks& known,
                                              std::size_t count, double separation);

}  // namespace wristwise
