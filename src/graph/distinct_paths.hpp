#pragma once

#include <vector>

#include "graph/graph_search.hpp"

namespace wristwise {

struct DistinctPath {
  LadderPath path;
  std::size_t differs_at = 0;  ///< rung
};

/// For each configuration of a rung the number of the region that it lies in: configurations that
/// can be used are joined where no joint differs by more than `gap` (rad or m, the shorter way
/// round); -1 for those that cannot. Another branch of the robot, or another side of an obstacle,
/// is another region.
std::vector<int> find_regions(const Rung& rung, const JointVector& period, double gap,
                              const std::vector<bool>& usable);

/// The best paths that really differ: each is the cheapest that on one of some rungs, spread over
/// the path, lies in a region that none of those before passes there.
/// @param best the least-cost path; it comes first
/// @return `count` paths, or fewer where there are no more
std::vector<DistinctPath> find_distinct_paths(GraphSearch& search, const std::vector<Rung>& rungs,
                                              const LadderPath& best, KnownChecks& known,
                                              std::size_t count, double gap);

}  // namespace wristwise
