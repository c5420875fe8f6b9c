#include <algorithm>
#include <cmath>

#include "wristwise/error.hpp"
#include "wristwise/seam.hpp"

namespace wristwise {

namespace {

constexpr double kTimeTolerance = 1e-6;  // s, by which given times may miss the seam's own

void check_times(const Seam& seam, const std::vector<double>& times) {
  if (times.size() < 2)
    throw InvalidInput("times", std::to_string(times.size()) + " given", "at least two");
  for (std::size_t i = 0; i < times.size(); ++i) {
    const std::string where = "times[" + std::to_string(i) + "]";
    if (!std::isfinite(times[i])) throw InvalidInput(where, "not finite");
    if (i > 0 && times[i] <= times[i - 1])
      throw InvalidInput(where, std::to_string(times[i]) + " s does not increase");
    if (times[i] < seam.start_time() - kTimeTolerance ||
        times[i] > seam.end_time() + kTimeTolerance)
      throw InvalidInput(
          where, std::to_string(times[i]) + " s is not on the seam",
          std::to_string(seam.start_time()) + " to " + std::to_string(seam.end_time()) + " s");
  }
}

/// The waypoint that ends the stretch on which t lies; the nearest one where t is within tolerance.
std::vector<Waypoint>::const_iterator waypoint_from(const std::vector<Waypoint>& waypoints,
                                                    double t) {
  const auto found =
      std::lower_bound(waypoints.begin(), waypoints.end(), t - kTimeTolerance,
                       [](const Waypoint& waypoint, double time) { return waypoint.time < time; });
  return found == waypoints.end() ? std::prev(found) : found;
}

/// The waypoint whose box holds between these two.
const Waypoint& governing(const Waypoint& from, const Waypoint& to) {
  return from.welding ? to : from;
}

Waypoint waypoint_at(const Task& task, double t) {
  const auto next = waypoint_from(task.waypoints, t);
  const bool is_given = std::abs(next->time - t) <= kTimeTolerance;
  Waypoint waypoint =
      is_given || next == task.waypoints.begin() ? *next : governing(*std::prev(next), *next);
  waypoint.time = t;
  if (is_given) return waypoint;
  if (task.seam.piece_at(t).kind == SeamPiece::Kind::move)
    throw InvalidInput("time " + std::to_string(t) + " s",
                       "lies on a move to or from a joint waypoint, where no path is prescribed",
                       "times on the seam, or those of its joint waypoints");
  waypoint.frame = task.seam.frame_at(t);
  waypoint.joints.reset();
  return waypoint;
}

bool is_welding(const Waypoint& waypoint) { return waypoint.welding; }

std::size_t count_joint_waypoints(const Task& task) {
  return static_cast<std::size_t>(
      std::count_if(task.waypoints.begin(), task.waypoints.end(),
                    [](const Waypoint& waypoint) { return waypoint.joints.has_value(); }));
}

}  // namespace

double Task::weld_start() const {
  const auto first = std::find_if(waypoints.begin(), waypoints.end(), is_welding);
  return first == waypoints.end() ? seam.start_time() : first->time;
}

double Task::weld_end() const {
  const auto last = std::find_if(waypoints.rbegin(), waypoints.rend(), is_welding);
  return last == waypoints.rend() ? seam.end_time() : last->time;
}

Task Task::retimed(const Trajectory& seam_time) const {
  Task task = *this;
  task.seam = seam.retimed(seam_time);
  for (std::size_t i = 0; i < waypoints.size(); ++i) {
    double& time = task.waypoints[i].time;
    time = task.seam.real_time(seam.nominal_time(time));
    if (i > 0 && time <= task.waypoints[i - 1].time)
      throw InvalidInput("seam time", "waypoints " + std::to_string(i - 1) + " and " +
                                          std::to_string(i) + " would be passed at once");
  }
  return task;
}

Task Task::with_waypoints_at(const std::vector<double>& times) const {
  if (waypoints.empty()) throw InvalidInput("task", "no waypoints", "at least two");
  check_times(seam, times);
  Task task = *this;
  task.waypoints.clear();
  for (const double t : times) task.waypoints.push_back(waypoint_at(*this, t));
  if (count_joint_waypoints(task) != count_joint_waypoints(*this))
    throw InvalidInput("times", "a joint waypoint of the path is left out or repeated",
                       "the time of each joint waypoint, once");
  return task;
}

std::optional<ToleranceBox> Task::tolerance_between(std::size_t interval) const {
  if (interval + 1 >= waypoints.size())
    throw InvalidInput("interval " + std::to_string(interval), "beyond the last waypoint");
  const double middle = 0.5 * (waypoints[interval].time + waypoints[interval + 1].time);
  if (seam.piece_at(middle).kind == SeamPiece::Kind::move) return std::nullopt;
  return governing(waypoints[interval], waypoints[interval + 1]).tolerance;
}

void validate_joint_waypoints(const Task& task, const Robot& robot) {
  for (std::size_t i = 0; i < task.waypoints.size(); ++i) {
    if (const auto& joints = task.waypoints[i].joints)
      cut_to_limits(robot, *joints, "waypoint " + std::to_string(i));
  }
}

}  // namespace wristwise
