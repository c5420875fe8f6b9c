#pragma once

#include <cstddef>

#include "graph/joint_metric.hpp"

namespace wristwise {

/// The vertices of a rung as columns: value of joint j at vertex u in positions[j * count + u].
struct RungColumns {
  const double* positions = nullptr;
  std::size_t count = 0;
};

/// total[u] = distance[u] + cost(u, target), or infinity where a joint steps farther than
/// max_step[j] (F17). Returns the least total. Runs on the widest vectors of the machine, with the
/// same result on each.
double relax_towards(const RungColumns& from, const double* distance, const double* target,
                     const JointMetric& metric, const double* max_step, double* total);

}  // namespace wristwise
