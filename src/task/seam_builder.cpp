#include "task/seam_builder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "task/stretches.hpp"
#include "wristwise/error.hpp"

namespace wristwise {

namespace {

constexpr double kMostIntervals = 1e6;
constexpr double kRoundOff = 1e-9;  // relative, so that 0.3 m / 0.1 m counts as 3 intervals

bool is_given_point_by_point(const Segment& segment) {
  return std::holds_alternative<PoseListSegment>(segment.shape) ||
         std::holds_alternative<JointListSegment>(segment.shape);
}

void check_description(const SeamDescription& description) {
  const auto& [segments, speed, spacing, waypoints, where] = description;
  if (segments.empty()) throw InvalidInput(where, "no segments", "at least one");
  if (speed && !(*speed > 0 && std::isfinite(*speed)))
    throw InvalidInput(where, fmt::format("speed is {}", *speed), "a positive speed, m/s");
  if (spacing && !(*spacing > 0 && std::isfinite(*spacing)))
    throw InvalidInput(where, fmt::format("spacing is {}", *spacing), "a positive length, m");
  if (waypoints && *waypoints < 2)
    throw InvalidInput(where, fmt::format("{} waypoints", *waypoints), "at least two");
  if (spacing && waypoints)
    throw InvalidInput(where, "both `spacing` and `waypoints` are given", "one of them");
  if (!spacing && !waypoints &&
      !std::all_of(segments.begin(), segments.end(), is_given_point_by_point))
    throw InvalidInput(where, "neither `spacing` nor `waypoints` is given", "one of them");
}

bool is_cut(const Stretch& stretch) { return stretch.piece.kind != SeamPiece::Kind::move; }

int intervals_by_spacing(double length, double spacing) {
  return std::max(1, static_cast<int>(std::ceil(length / spacing * (1 - kRoundOff))));
}

/// Deals `total` intervals out in proportion to length, at least one each, by the method of the
/// largest remainder.
std::vector<int> deal_out(const std::vector<double>& lengths, int total) {
  const double whole = std::accumulate(lengths.begin(), lengths.end(), 0.0);
  std::vector<double> quota(lengths.size());
  std::vector<int> count(lengths.size());
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    quota[i] = whole > 0 ? total * lengths[i] / whole : 1;
    count[i] = std::max(1, static_cast<int>(std::floor(quota[i] * (1 + kRoundOff))));
  }
  int left = total - std::accumulate(count.begin(), count.end(), 0);
  for (; left != 0 && !lengths.empty(); left += left > 0 ? -1 : 1) {
    std::size_t best = lengths.size();
    double best_remainder = 0;
    for (std::size_t i = 0; i < lengths.size(); ++i) {
      if (left < 0 && count[i] == 1) continue;
      const double remainder = left > 0 ? quota[i] - count[i] : count[i] - quota[i];
      if (best == lengths.size() || remainder > best_remainder + kRoundOff) {
        best = i;
        best_remainder = remainder;
      }
    }
    count[best] += left > 0 ? 1 : -1;
  }
  return count;
}

std::vector<int> count_intervals(const SeamDescription& description,
                                 const std::vector<Stretch>& stretches) {
  std::vector<int> counts(stretches.size(), 1);
  if (description.spacing) {
    double total = 0;
    for (const Stretch& stretch : stretches) total += stretch.piece.length() / *description.spacing;
    if (total > kMostIntervals)
      throw InvalidInput(
          description.where,
          fmt::format("spacing of {} m makes {:.0f} waypoints", *description.spacing, total),
          "at most a million");
    for (std::size_t i = 0; i < stretches.size(); ++i)
      if (is_cut(stretches[i]))
        counts[i] = intervals_by_spacing(stretches[i].piece.length(), *description.spacing);
  } else if (description.waypoints) {
    if (static_cast<std::size_t>(*description.waypoints) < stretches.size() + 1)
      throw InvalidInput(
          description.where,
          fmt::format("{} waypoints are too few to keep all segment ends", *description.waypoints),
          fmt::format("at least {}", stretches.size() + 1));
    if (*description.waypoints > kMostIntervals)
      throw InvalidInput(description.where, fmt::format("{} waypoints", *description.waypoints),
                         "at most a million");
    std::vector<double> lengths;
    for (const Stretch& stretch : stretches)
      if (is_cut(stretch)) lengths.push_back(stretch.piece.length());
    const auto moves = static_cast<int>(stretches.size() - lengths.size());
    if (lengths.empty() && *description.waypoints != moves + 1)
      throw InvalidInput(description.where,
                         fmt::format("{} waypoints, but moves between joint waypoints are not cut",
                                     *description.waypoints),
                         fmt::format("{}", moves + 1));
    const std::vector<int> dealt = deal_out(lengths, *description.waypoints - 1 - moves);
    auto next = dealt.begin();
    for (std::size_t i = 0; i < stretches.size(); ++i)
      if (is_cut(stretches[i])) counts[i] = *next++;
  }
  return counts;
}

double duration_of(const Stretch& stretch, const SeamDescription& description) {
  if (stretch.duration) return *stretch.duration;
  if (!description.speed)
    throw InvalidInput(description.where, "missing key 'speed'",
                       "a speed, m/s, or times for every pose");
  return std::max(stretch.piece.length() / *description.speed, stretch.least_duration);
}

void cut(const Stretch& stretch, const SeamPiece& piece, int intervals,
         const ToleranceBox& tolerance, std::vector<Waypoint>& waypoints) {
  for (int k = 1; k <= intervals; ++k) {
    const double fraction = static_cast<double>(k) / intervals;
    Waypoint waypoint;
    waypoint.time = k == intervals
                        ? piece.end_time
                        : piece.start_time + fraction * (piece.end_time - piece.start_time);
    waypoint.frame = piece.frame_at(fraction);
    waypoint.tolerance = tolerance;
    if (k == intervals) waypoint.joints = stretch.end_joints;
    waypoints.push_back(std::move(waypoint));
  }
}

}  // namespace

Task build_task(const Robot& robot, const SeamDescription& description) {
  check_description(description);
  const Stretches layout = lay_out(robot, description.segments);
  if (layout.stretches.empty())
    throw InvalidInput(description.where, "the seam has only one waypoint", "at least two");
  const std::vector<int> intervals = count_intervals(description, layout.stretches);

  Task task;
  task.waypoints.push_back({layout.start_time, layout.start, description.segments.front().tolerance,
                            layout.start_joints});
  std::vector<SeamPiece> pieces;
  double time = layout.start_time;
  for (std::size_t i = 0; i < layout.stretches.size(); ++i) {
    const Stretch& stretch = layout.stretches[i];
    SeamPiece piece = stretch.piece;
    piece.start_time = time;
    piece.end_time = time += duration_of(stretch, description);
    cut(stretch, piece, intervals[i], description.segments[stretch.segment].tolerance,
        task.waypoints);
    pieces.push_back(std::move(piece));
  }
  task.seam = Seam(std::move(pieces));
  return task;
}

}  // namespace wristwise
