#pragma once

#include <cstddef>
#include <vector>

#include "wristwise/wristwise.hpp"

namespace wristwise::benchmarks {

/// The reference for stage 1: a plain forward dynamic programme without stored edges, in single
/// precision, vectorised, that looks at every edge. Six joints, L1 cost, no checks of any kind.
struct PlainResult {
  std::vector<JointVector> path;
  double cost = 0;  ///< of the path, in double
  std::size_t vertices = 0;
};
PlainResult plain_dynamic_programme(const Problem& problem, const InverseKinematics& ik);

}  // namespace wristwise::benchmarks
