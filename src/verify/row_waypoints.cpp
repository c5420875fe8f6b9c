#include "verify/row_waypoints.hpp"

#include <algorithm>
#include <iterator>

namespace wristwise {

namespace {

constexpr double kTimeTolerance = 1e-6;  // s, by which a row may miss its waypoint

bool is_row(double time, const std::vector<double>& rows) {
  const auto next = std::lower_bound(rows.begin(), rows.end(), time - kTimeTolerance);
  return next != rows.end() && *next <= time + kTimeTolerance;
}

/// A row between two waypoints, with the box that holds there.
Waypoint knot_between(const Waypoint& from, const Waypoint& to, const Seam& seam, double t) {
  Waypoint knot = from.welding ? to : from;
  knot.time = t;
  knot.frame = seam.frame_at(t);
  knot.joints.reset();
  return knot;
}

}  // namespace

RowWaypoints row_waypoints(const Task& task, const std::vector<double>& times) {
  const bool has_all =
      std::all_of(task.waypoints.begin(), task.waypoints.end(),
                  [&](const Waypoint& waypoint) { return is_row(waypoint.time, times); });
  const double first = task.waypoints.front().time, last = task.waypoints.back().time;
  const bool is_within =
      times.front() >= first - kTimeTolerance && times.back() <= last + kTimeTolerance;
  if (!has_all || !is_within)
    return {task.with_waypoints_at(times), std::vector<bool>(times.size(), false)};
  RowWaypoints rows{task, {}};
  rows.task.waypoints.clear();
  auto next = task.waypoints.begin();
  for (const double t : times) {
    const bool is_waypoint = next != task.waypoints.end() && next->time <= t + kTimeTolerance;
    rows.task.waypoints.push_back(
        is_waypoint ? *next : knot_between(*std::prev(next), *next, task.seam, t));
    rows.task.waypoints.back().time = t;
    rows.is_knot.push_back(!is_waypoint);
    if (is_waypoint) ++next;
  }
  return rows;
}

}  // namespace wristwise
