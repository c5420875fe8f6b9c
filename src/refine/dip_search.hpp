#pragma once

#include <vector>

#include "refine/spline.hpp"
#include "wristwise/clearance.hpp"
#include "wristwise/seam.hpp"

namespace wristwise {

/// A time between waypoints at which a motion breaks what it must hold there.
struct Dip {
  std::size_t interval = 0;  ///< between waypoints `interval` and `interval` + 1
  double time = 0;           ///< s
  double depth = 0;          ///< m or rad
};

/// Looks between the waypoints, at the spacing of `samples_per_interval` and at least every
/// `max_step` (m) of TCP travel: where the box widened by the task's between-tolerance is left, or
/// a distance is below `required` (m). The worst time of each interval that has one.
std::vector<Dip> find_dips(const Task& task, const Spline& spline, ClearanceChecker& checker,
                           double required, int samples_per_interval, double max_step = 1e-3);

}  // namespace wristwise
