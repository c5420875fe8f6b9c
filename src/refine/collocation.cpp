#include "refine/collocation.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace wristwise {

namespace {

/// Half of the way to the neighbours on both sides, in units of `unit`.
void weigh(std::vector<PointConstraint>& points, double unit) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double before = i > 0 ? points[i].time - points[i - 1].time : 0;
    const double after = i + 1 < points.size() ? points[i + 1].time - points[i].time : 0;
    points[i].weight = std::max(0.5 * (before + after) / unit, 1e-3);
  }
}

const PointConstraint& nearest(const std::vector<PointConstraint>& points, double time) {
  const auto after = std::lower_bound(
      points.begin(), points.end(), time,
      [](const PointConstraint& point, double value) { return point.time < value; });
  if (after == points.end()) return points.back();
  if (after == points.begin()) return *after;
  return time - std::prev(after)->time <= after->time - time ? *std::prev(after) : *after;
}

void take_over_multipliers(const std::vector<PointConstraint>& before, PointConstraint& point) {
  const PointConstraint& from = nearest(before, point.time);
  for (const PointConstraint::Row& row : from.rows) {
    const double multiplier = row.bounds.multiplier / from.weight * point.weight;
    const auto same = std::find_if(point.rows.begin(), point.rows.end(), [&](const auto& own) {
      return own.kind == row.kind && own.index == row.index;
    });
    if (same != point.rows.end()) {
      same->bounds.multiplier = multiplier;
    } else if (row.kind == PointConstraint::Kind::clearance) {
      point.rows.push_back(row);
      point.rows.back().bounds.multiplier = multiplier;
    }
  }
}

/// How far the posture is outside what the waypoint asks, by coordinate or joint.
std::vector<double> excess(const Robot& robot, const Waypoint& waypoint, const JointVector& q) {
  std::vector<double> result;
  if (waypoint.joints) {
    const JointVector outside = (waypoint.joints->lower - q).cwiseMax(q - waypoint.joints->upper);
    for (const double value : outside) result.push_back(std::max(0.0, value));
    return result;
  }
  const Vector6 outside = box_excess(
      waypoint.tolerance, deviation(waypoint.tolerance, waypoint.frame, tcp_pose(robot, q)));
  result.assign(outside.data(), outside.data() + outside.size());
  return result;
}

}  // namespace

std::vector<std::size_t> Collocation::spread(const SplineBasis& basis, int per_span) const {
  std::vector<std::size_t> chosen = {0};
  const auto& waypoints = task_.waypoints;
  std::size_t i = 1;
  for (int span = 0; span < basis.span_count(); ++span) {
    const double end = basis.breakpoints()[static_cast<std::size_t>(span) + 1];
    const std::size_t first = i;
    while (i + 1 < waypoints.size() && waypoints[i].time < end * (1 + 1e-15)) ++i;
    const std::size_t count = i - first;
    const std::size_t kept = std::min(count, static_cast<std::size_t>(per_span));
    for (std::size_t k = 0; k < count; ++k) {
      const bool takes_turn = (k + 1) * kept / count > k * kept / count;
      if (takes_turn || waypoints[first + k].joints) chosen.push_back(first + k);
    }
  }
  if (waypoints.size() > 1) chosen.push_back(waypoints.size() - 1);
  return chosen;
}

std::vector<PointConstraint> Collocation::choose(const SplineBasis& basis, int per_span,
                                                 double unit,
                                                 const std::vector<PointConstraint>& before) {
  std::vector<PointConstraint> points;
  std::fill(included_.begin(), included_.end(), false);
  for (const std::size_t i : spread(basis, per_span)) {
    points.push_back(constraint_at_waypoint(task_.waypoints[i], basis));
    included_[i] = true;
  }
  weigh(points, unit);
  if (before.empty()) return points;
  for (PointConstraint& point : points) take_over_multipliers(before, point);
  return points;
}

bool Collocation::is_complete() const {
  return std::find(included_.begin(), included_.end(), false) == included_.end();
}

std::vector<PointConstraint> Collocation::violated(const Robot& robot, const Spline& spline,
                                                   double tolerance, double unit) const {
  std::map<std::pair<int, std::size_t>, std::pair<double, std::size_t>> worst;  // span, coordinate
  for (std::size_t i = 0; i < task_.waypoints.size(); ++i) {
    const SplineBasis::Values basis = spline.basis.at(task_.waypoints[i].time);
    const std::vector<double> outside = excess(robot, task_.waypoints[i], spline.value(basis));
    for (std::size_t k = 0; k < outside.size(); ++k) {
      if (outside[k] <= tolerance) continue;
      auto& entry = worst[{basis.first, k}];
      entry = std::max(entry, std::make_pair(outside[k], i));
    }
  }
  std::set<std::size_t> waypoints;
  for (const auto& entry : worst) {
    const std::size_t i = entry.second.second;
    if (!included_[i]) waypoints.insert(i);
  }
  std::vector<PointConstraint> points;
  const auto& breakpoints = spline.basis.breakpoints();
  for (const std::size_t i : waypoints) {
    points.push_back(constraint_at_waypoint(task_.waypoints[i], spline.basis));
    const auto span = static_cast<std::size_t>(points.back().basis.first);
    points.back().weight =
        std::max(0.25 * (breakpoints[span + 1] - breakpoints[span]) / unit, 1e-3);
  }
  return points;
}

}  // namespace wristwise
