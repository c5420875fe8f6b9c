// What the verification shows for all t, and what it must not, on corners that are rounded off,
// stopped at or slowed down for, on run-ins and on run-outs. The gantry's joints are the TCP's
// place and its tilt: what is planted is the deviation.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "gantry.hpp"
#include "wristwise/seam_description.hpp"
#include "wristwise/verification.hpp"

namespace wristwise {
namespace {

namespace gantry = test::gantry;
using Kind = CornerOptions::Kind;

constexpr double kTurn = 0.7;        // rad, of the frame at the corner
constexpr int kRows = 16;            // of the trajectory, to an interval of waypoints
constexpr double kHalfBump = 5e-4;   // s
constexpr double kMoreOnRun = 1e-3;  // m, by which the box of a run is wider

Pose tilted_at(double y, double z, double angle) {
  Pose pose(Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitX()));
  pose.translation() << 0, y, z;
  return pose;
}

/// 40 mm and 40 mm at 10 mm/s, in the plane across x; the second leg rises and is tilted.
Task corner_task(Kind kind) {
  const Pose corner = tilted_at(0.04, 0, 0), end = tilted_at(0.07, 0.03, kTurn);
  Pose leaving = corner;
  leaving.linear() = end.linear();
  SeamDescription seam;
  seam.segments = {{LineSegment{tilted_at(0, 0, 0), corner}, gantry::box(0, 0), "first"},
                   {LineSegment{leaving, end}, gantry::box(0, 0), "second"}};
  if (kind == Kind::slow)  // the frame may not jump there
    seam.segments[0].shape = LineSegment{tilted_at(0, 0, kTurn), leaving};
  seam.speed = 0.01;
  seam.spacing = 0.004;
  seam.corners.kind = kind;
  seam.corners.distance = 0.005;
  seam.corners.speed_ratio = 0.3;
  seam.run_in.emplace();
  seam.run_in->length = 0.01;
  seam.run_out.emplace();
  seam.run_out->away = Eigen::Vector3d(0.005, 0, -0.02);
  return build_task(*gantry::robot(), seam);
}

JointVector following(const Seam& seam, double t) {
  const Pose frame = seam.frame_at(t);
  const Eigen::Vector3d p = frame.translation();
  return gantry::posture(p.x(), p.y(), p.z(), std::atan2(frame(2, 1), frame(1, 1)));
}

/// A motion by its rows.
struct Rows {
  std::vector<double> times;
  std::vector<JointVector> positions, velocities, accelerations;

  Trajectory trajectory() const { return {times, positions, velocities, accelerations}; }
};

/// Follows the seam, `lag` seconds behind it, by numeric derivatives.
Rows rows_along(const Task& task, double lag = 0) {
  Rows rows;
  for (std::size_t i = 0; i + 1 < task.waypoints.size(); ++i) {
    const double from = task.waypoints[i].time, to = task.waypoints[i + 1].time;
    for (int k = 0; k < kRows; ++k) rows.times.push_back(from + (to - from) * k / kRows);
  }
  rows.times.push_back(task.waypoints.back().time);
  const double h = 1e-4;
  for (const double time : rows.times) {
    const double t = time - lag;
    const JointVector before = following(task.seam, t - h), at = following(task.seam, t),
                      after = following(task.seam, t + h);
    rows.positions.push_back(at);
    rows.velocities.push_back((after - before) / (2 * h));
    rows.accelerations.push_back((after - 2 * at + before) / (h * h));
  }
  return rows;
}

/// Out by `size` (m or rad) in one joint and in again, within 2 ms in the middle of two rows.
double plant(Rows& rows, std::size_t row, int joint, double size) {
  const Trajectory smooth = rows.trajectory();
  const double middle = 0.5 * (rows.times[row] + rows.times[row + 1]);
  // A quintic that leaves with v and arrives with -v is 5/32 of 2 v (2 h) away in the middle.
  const double speed = 8 * size / (5 * kHalfBump);
  Rows bump;
  for (const double step : {-2.0, -1.0, 1.0, 2.0}) {
    const double t = middle + step * kHalfBump;
    bump.times.push_back(t);
    bump.positions.push_back(smooth.evaluate(t));
    bump.velocities.push_back(smooth.evaluate(t, 1));
    bump.accelerations.push_back(smooth.evaluate(t, 2));
  }
  bump.velocities[1][joint] += speed;
  bump.velocities[2][joint] -= speed;
  const auto insert = [&](auto& into, const auto& what) {
    into.insert(into.begin() + static_cast<std::ptrdiff_t>(row) + 1, what.begin(), what.end());
  };
  insert(rows.times, bump.times);
  insert(rows.positions, bump.positions);
  insert(rows.velocities, bump.velocities);
  insert(rows.accelerations, bump.accelerations);
  return middle;
}

Verification verify_rows(const Task& task, const Rows& rows) {
  return verify(task, gantry::clearance(gantry::robot()), rows.trajectory());
}

bool is_named(const Verification& found, double t) {
  return std::any_of(found.deviation_not_shown.begin(), found.deviation_not_shown.end(),
                     [&](const TimeRange& range) { return range.from <= t && t <= range.to; });
}

class VerificationOnSeam : public testing::TestWithParam<Kind> {};

TEST_P(VerificationOnSeam, ShowsAMotionThatFollows) {
  const Task task = corner_task(GetParam());
  const Rows rows = rows_along(task);
  const Verification found = verify_rows(task, rows);
  EXPECT_TRUE(found.deviation_shown);
  // What the rows leave; no motion is exact where the velocity jumps.
  EXPECT_LT(found.path_error, GetParam() == Kind::slow ? 6e-5 : 5e-6);
  EXPECT_LT(found.angle_error, 1e-4);
  EXPECT_LT(found.tolerance_excess_between.maxCoeff(), 1e-9);
  EXPECT_LT(found.samples, 3 * rows.times.size());
}

/// Wherever it is: on each part of the seam, in place and tilt.
TEST_P(VerificationOnSeam, CatchesWhatIsPlanted) {
  const Task task = corner_task(GetParam());
  const Rows smooth = rows_along(task);
  const double between = task.between_position, tilt = task.between_angle;
  for (std::size_t row = kRows / 2; row + 1 < smooth.times.size(); row += kRows) {
    const double t = 0.5 * (smooth.times[row] + smooth.times[row + 1]);
    const bool on_run = t < task.weld_start() || t > task.weld_end();
    const double widest = between + (on_run ? kMoreOnRun : 0);
    for (const int joint : {1, 2}) {
      Rows rows = smooth;
      plant(rows, row, joint, 0.6 * widest);
      EXPECT_TRUE(verify_rows(task, rows).deviation_shown) << t;
      rows = smooth;
      plant(rows, row, joint, 2 * widest);
      const Verification found = verify_rows(task, rows);
      EXPECT_FALSE(found.deviation_shown) << t;
      EXPECT_TRUE(is_named(found, t)) << t;
      EXPECT_FALSE(found.passed);
      EXPECT_GT(found.tolerance_excess_between.maxCoeff(), 0.3 * widest) << t;
    }
    if (on_run) continue;
    Rows rows = smooth;
    plant(rows, row, 3, 2 * tilt);
    const Verification found = verify_rows(task, rows);
    EXPECT_TRUE(is_named(found, t)) << t;
    EXPECT_NEAR(found.tolerance_excess_between[3], tilt, 0.2 * tilt) << t;
  }
}

/// Behind by twice what is granted at weld speed: too far except where the seam is run slowly.
TEST_P(VerificationOnSeam, ALagShowsWhereTheSeamIsFast) {
  const Task task = corner_task(GetParam());
  const Verification found = verify_rows(task, rows_along(task, 2 * task.between_position / 0.01));
  int too_far = 0, slow = 0;
  for (int i = 1; i < 2000; ++i) {
    const double t = task.weld_start() + (task.weld_end() - task.weld_start()) * i / 2000;
    const Pose now = task.seam.frame_at(t);
    const Pose then = task.seam.frame_at(t - 2 * task.between_position / 0.01);
    const Eigen::Vector3d off = now.linear().transpose() * (then.translation() - now.translation());
    if (off.cwiseAbs().maxCoeff() < 0.9 * task.between_position) ++slow;
    if (off.cwiseAbs().maxCoeff() < 1.1 * task.between_position) continue;
    ++too_far;
    EXPECT_TRUE(is_named(found, t)) << t;
  }
  EXPECT_GT(too_far, 500);
  if (GetParam() != Kind::blend) {
    EXPECT_GT(slow, 50);
  }
}

INSTANTIATE_TEST_SUITE_P(Corners, VerificationOnSeam,
                         testing::Values(Kind::blend, Kind::stop, Kind::slow),
                         [](const testing::TestParamInfo<Kind>& of) {
                           if (of.param == Kind::blend) return "RoundedOff";
                           return of.param == Kind::stop ? "StoppedAt" : "SlowedDownFor";
                         });

}  // namespace
}  // namespace wristwise
