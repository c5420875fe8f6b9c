#pragma once

#include <vector>

#include "wristwise/seam.hpp"

namespace wristwise {

struct WeldStretch {
  double from = 0, to = 0;  ///< s
};

/// Where the seam is welded, in order: not in run-in and run-out, and not on moves to or from joint
/// waypoints.
std::vector<WeldStretch> weld_stretches(const Task& task);

}  // namespace wristwise
