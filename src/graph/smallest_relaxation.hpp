#pragma once

#include <string>

#include "graph/graph_search.hpp"

namespace wristwise {

/// What would make a task feasible for which stage 1 has no path, found by trying: finer samples, a
/// wider tolerance (each coordinate by itself, on both sides), a smaller clearance, a slower weld.
/// Each is first tried around the waypoint that fails, the smallest that helps there on the whole
/// seam. The number of moves that all trials together may check is limited.
/// @param too_fast a slower weld may help
/// @return one line, the smallest relaxations first; empty where nothing that was tried helps
std::string smallest_relaxation(const SamplingInput& input, const Task& task,
                                std::size_t failing_waypoint, bool too_fast, double epsilon,
                                const Monitor& monitor);

}  // namespace wristwise
