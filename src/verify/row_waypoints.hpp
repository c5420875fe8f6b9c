#pragma once

#include <vector>

#include "wristwise/seam.hpp"

namespace wristwise {

/// The task with a waypoint for each row of a motion. Where all waypoints of the task are rows, the
/// others are mere knots, to which applies what holds between waypoints; else every row counts as a
/// waypoint.
struct RowWaypoints {
  Task task;
  std::vector<bool> is_knot;  ///< one per row
};

/// @throws InvalidInput where the times are not those of a motion along the seam
RowWaypoints row_waypoints(const Task& task, const std::vector<double>& times);

}  // namespace wristwise
