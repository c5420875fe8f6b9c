#include "refine/seam_features.hpp"

#include <algorithm>
#include <cmath>

namespace wristwise {

namespace {

/// m, of a jump of the third derivative times the spacing cubed; a curve's error is about a
/// hundredth of it.
constexpr double kJumpThatShows = 2e-4;
constexpr double kJumpFollowed = 1e-4;     ///< m, of a jump of acceleration times a span squared
constexpr double kFinest = 0.05;           ///< of the spacing
constexpr double kFinestAtACorner = 1e-3;  ///< of the spacing
constexpr int kSpansOfARoundedCorner = 8;
constexpr int kSpansOfASharpCorner = 4;  ///< while the TCP goes as far as it may be off the seam

void add_law_knots(const Task& task, double spacing, std::vector<SeamFeature>& features) {
  if (!task.seam.is_retimed()) return;
  const Trajectory& law = task.seam.seam_time();
  const double speed = task.seam.length() / (law.positions().back() - law.positions().front())[0];
  for (std::size_t i = 1; i + 1 < law.times().size(); ++i) {
    const double t = law.times()[i], a_little = 1e-9 * (law.times()[i + 1] - law.times()[i - 1]);
    const double jump = (law.evaluate(t + a_little, 3) - law.evaluate(t - a_little, 3)).norm();
    if (speed * jump * std::pow(spacing, 3) > kJumpThatShows)
      features.push_back({t, kFinest * spacing});
  }
}

void add_ends_of_welding(const Task& task, double spacing, std::vector<SeamFeature>& features) {
  for (std::size_t i = 0; i + 1 < task.waypoints.size(); ++i) {
    const Waypoint &here = task.waypoints[i], &next = task.waypoints[i + 1];
    if (here.welding != next.welding)
      features.push_back({here.welding ? here.time : next.time, kFinest * spacing});
  }
}

void add_rounded_corners(const Task& task, double spacing, std::vector<SeamFeature>& features) {
  for (const SeamPiece& piece : task.seam.pieces()) {
    if (piece.kind != SeamPiece::Kind::curve) continue;
    const double from = task.seam.real_time(piece.start_time);
    const double to = task.seam.real_time(piece.end_time);
    const double finest = std::min((to - from) / kSpansOfARoundedCorner, spacing);
    for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0})
      features.push_back({from + share * (to - from), finest});
  }
}

/// m/s^2, of the TCP in a piece run at weld speed, at its beginning or its end.
Eigen::Vector3d acceleration(const SeamPiece& piece, bool at_end) {
  if (piece.kind == SeamPiece::Kind::line) return Eigen::Vector3d::Zero();
  constexpr double kStep = 1e-3;  // of the piece
  const auto at = [&](int steps) -> Eigen::Vector3d {
    return piece.frame_at(at_end ? 1 - steps * kStep : steps * kStep).translation();
  };
  return (at(0) - 2 * at(1) + at(2)) / std::pow(kStep * (piece.end_time - piece.start_time), 2);
}

/// Where lines and arcs meet.
void add_jumps_of_acceleration(const Task& task, double spacing,
                               std::vector<SeamFeature>& features) {
  const std::vector<SeamPiece>& pieces = task.seam.pieces();
  for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
    const double t = task.seam.real_time(pieces[i].end_time);
    const double jump = std::pow(task.seam.speed_ratio(t), 2) *
                        (acceleration(pieces[i + 1], false) - acceleration(pieces[i], true)).norm();
    if (jump * std::pow(spacing, 2) > kJumpThatShows)
      features.push_back({t, std::max(std::sqrt(kJumpFollowed / jump), kFinest * spacing), false});
  }
}

/// Corners at full speed are left to the rows that there are: the curve may cut them inside the
/// tolerance.
void add_slow_corners(const Task& task, double spacing, std::vector<SeamFeature>& features) {
  if (!task.seam.is_retimed()) return;
  for (std::size_t i = 0; i + 1 < task.seam.pieces().size(); ++i) {
    const double t = task.seam.real_time(task.seam.pieces()[i].end_time);
    const double a_little = 1e-6 * (task.seam.end_time() - task.seam.start_time());
    const Eigen::Vector3d at = task.seam.frame_at(t).translation();
    const Eigen::Vector3d before = at - task.seam.frame_at(t - a_little).translation();
    const Eigen::Vector3d after = task.seam.frame_at(t + a_little).translation() - at;
    const double jump = (after - before).norm() / a_little;  // m/s
    if (!(jump > 1e-3 * (after.norm() + before.norm()) / a_little)) continue;
    const double allowed = task.between_position / jump;
    features.push_back({t, std::max(allowed / kSpansOfASharpCorner, kFinestAtACorner * spacing)});
  }
}

}  // namespace

std::vector<SeamFeature> seam_features(const Task& task, double spacing) {
  std::vector<SeamFeature> features;
  add_law_knots(task, spacing, features);
  add_jumps_of_acceleration(task, spacing, features);
  add_ends_of_welding(task, spacing, features);
  add_rounded_corners(task, spacing, features);
  add_slow_corners(task, spacing, features);
  const double start = task.waypoints.front().time, end = task.waypoints.back().time;
  features.erase(std::remove_if(features.begin(), features.end(),
                                [&](const SeamFeature& feature) {
                                  return feature.time <= start || feature.time >= end ||
                                         feature.finest >= spacing;
                                }),
                 features.end());
  std::sort(features.begin(), features.end(),
            [](const SeamFeature& a, const SeamFeature& b) { return a.time < b.time; });
  return features;
}

}  // namespace wristwise
