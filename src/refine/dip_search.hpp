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
  double depth = 0;          ///< m or rad; 0 where the box could not be shown to hold
};

/// Looks between the waypoints where the box widened by the task's between-tolerance is left (F30),
/// and where a distance is below `required` (F31). The worst time of each interval that has one,
/// for the box and for the distance. Nothing is missed: where there is no dip the box holds for all
/// t to within 5e-7 m and rad, and every distance is at least `required` - `resolution` (m).
std::vector<Dip> find_dips(const Task& task, const Spline& spline, ClearanceChecker& checker,
                           double required, double resolution);

}  // namespace wristwise
