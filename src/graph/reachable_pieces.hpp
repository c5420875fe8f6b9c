#pragma once

#include <utility>
#include <vector>

#include "graph/graph_search.hpp"

namespace wristwise {

/// The pieces that the seam falls into where it has no path as a whole: first and last waypoint of
/// each, from the start as far as possible, and on from the next waypoint that can be passed. One
/// waypoint is no piece.
/// @param reached waypoints of the first piece; 0: it is not known
std::vector<std::pair<std::size_t, std::size_t>> reachable_pieces(const SamplingInput& input,
                                                                  const Task& task,
                                                                  std::size_t reached,
                                                                  double epsilon, int threads,
                                                                  const Monitor& monitor);

}  // namespace wristwise
