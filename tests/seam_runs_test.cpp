#include "task/seam_runs.hpp"

#include <gtest/gtest.h>

#include "invalid_input.hpp"
#include "seam_samples.hpp"

namespace wristwise {
namespace {

using test::at;
using test::describe;
using test::invalid_input;
using test::line;
using test::says;
using test::turned_at;

constexpr double kDegree = 0.017453292519943295;

Task build(const SeamDescription& description) {
  return build_task(test::sliding_robot(), description);
}

RunDescription along(double length) {
  RunDescription run;
  run.length = length;
  run.where = "run";
  return run;
}

RunDescription away(const Eigen::Vector3d& vector) {
  RunDescription run;
  run.away = vector;
  run.where = "run";
  return run;
}

Segment quarter_arc() {
  return {ArcSegment{at(0.1, 0, 0), {0, 0, 0}, Eigen::Vector3d::UnitZ(), 90 * kDegree}, {}, "arc"};
}

Eigen::Vector3d velocity(const Seam& seam, double t, double h = 1e-5) {
  return (seam.frame_at(t + h).translation() - seam.frame_at(t - h).translation()) / (2 * h);
}

Eigen::Vector3d acceleration(const Seam& seam, double t, double h = 1e-3) {
  return (seam.frame_at(t + h).translation() - 2 * seam.frame_at(t).translation() +
          seam.frame_at(t - h).translation()) /
         (h * h);
}

Eigen::Vector3d turn_rate(const Seam& seam, double t, double h = 1e-4) {
  const Eigen::AngleAxisd turn(seam.frame_at(t + h).linear() *
                               seam.frame_at(t - h).linear().transpose());
  return turn.angle() / (2 * h) * turn.axis();
}

TEST(RunIn, RisesToWeldSpeedAlongTheTangent) {
  SeamDescription description = describe({line(at(0, 0, 0), at(0.1, 0, 0))});
  description.run_in = along(0.01);
  const Task task = build(description);
  EXPECT_TRUE(task.rest_at_start);
  EXPECT_FALSE(task.rest_at_end);
  const Seam& seam = task.seam;
  EXPECT_NEAR(seam.start_time(), -2, 1e-15);
  EXPECT_EQ(seam.end_time(), 10);
  EXPECT_LT((seam.frame_at(-2).translation() - Eigen::Vector3d(-0.01, 0, 0)).norm(), 1e-15);
  for (const double t : test::steps(-1.95, 0, 0.05)) {
    const double w = 0.5 * (t + 2), v = 0.01 * w * w * (3 - 2 * w);
    EXPECT_LT((velocity(seam, t) - Eigen::Vector3d(v, 0, 0)).norm(), 1e-9) << t;
    EXPECT_TRUE(seam.frame_at(t).linear().isIdentity(1e-15));
  }
}

TEST(RunIn, WaypointsDoNotWeldAndAreWider) {
  SeamDescription description = describe({line(at(0, 0, 0), at(0.1, 0, 0))});
  description.segments[0].tolerance.upper[2] = 0.002;
  description.run_in = along(0.01);
  description.run_out = along(0.02);
  const Task task = build(description);
  int before = 0, after = 0, welding = 0;
  for (std::size_t i = 0; i < task.waypoints.size(); ++i) {
    const Waypoint& waypoint = task.waypoints[i];
    if (i > 0) {
      EXPECT_GT(waypoint.time, task.waypoints[i - 1].time);
    }
    EXPECT_LT((task.seam.frame_at(waypoint.time).matrix() - waypoint.frame.matrix()).norm(), 1e-14);
    const bool is_weld = waypoint.time >= 0 && waypoint.time <= 10;
    EXPECT_EQ(waypoint.welding, is_weld) << waypoint.time;
    EXPECT_NEAR(waypoint.tolerance.upper[2], is_weld ? 0.002 : 0.003, 1e-15);
    EXPECT_NEAR(waypoint.tolerance.lower[4], is_weld ? 0 : -kDegree, 1e-15);
    ASSERT_EQ(waypoint.sampled.has_value(), !is_weld);
    if (waypoint.sampled) {
      EXPECT_EQ(waypoint.sampled->upper, task.waypoints[4].tolerance.upper);
      EXPECT_EQ(waypoint.sampled->lower, task.waypoints[4].tolerance.lower);
    }
    before += waypoint.time < 0;
    after += waypoint.time > 10;
    welding += waypoint.welding;
  }
  EXPECT_EQ(before, 4);
  EXPECT_EQ(after, 8);
  EXPECT_EQ(welding, 21);
  EXPECT_EQ(task.waypoints[4].time, 0);
  EXPECT_EQ(task.waypoints[24].time, 10);
  EXPECT_NEAR(task.tolerance_between(3)->upper[2], 0.003, 1e-15);
  EXPECT_NEAR(task.tolerance_between(4)->upper[2], 0.002, 1e-15);
  EXPECT_NEAR(task.tolerance_between(23)->upper[2], 0.002, 1e-15);
  EXPECT_NEAR(task.tolerance_between(24)->upper[2], 0.003, 1e-15);
}

TEST(RunIn, SeamItselfIsTheSameWithIt) {
  SeamDescription description =
      describe({line(at(0, 0, 0), at(0.1, 0, 0)), line(at(0.1, 0, 0), at(0.1, 0.1, 0))});
  const Task plain = build(description);
  description.run_in = along(0.01);
  description.run_out = away({0, 0, -0.03});
  const Task task = build(description);
  std::size_t k = 0;
  for (const Waypoint& waypoint : task.waypoints) {
    if (!waypoint.welding) continue;
    EXPECT_EQ(waypoint.time, plain.waypoints[k].time);
    EXPECT_EQ(waypoint.frame.matrix(), plain.waypoints[k++].frame.matrix());
  }
  EXPECT_EQ(k, plain.waypoints.size());
}

TEST(RunIn, ArrivesFromAPointOfThePathFrame) {
  SeamDescription description = describe({line(turned_at(0, 0, 1), turned_at(0.1, 0, 1))});
  description.run_in = away({0.01, 0.02, -0.05});
  description.run_out = away({0, 0, -0.04});
  description.run_out->duration = 3;
  const Task task = build(description);
  const Seam& seam = task.seam;
  const Eigen::Vector3d approach = turned_at(0, 0, 1).linear() * Eigen::Vector3d(0.01, 0.02, -0.05);
  EXPECT_NEAR(seam.start_time(), -2 * approach.norm() / 0.01, 1e-12);
  EXPECT_NEAR(seam.end_time(), 13, 1e-12);
  EXPECT_LT((seam.frame_at(seam.start_time()).translation() - approach).norm(), 1e-15);
  EXPECT_LT((seam.frame_at(13).translation() - Eigen::Vector3d(0.1, 0, -0.04)).norm(), 1e-15);
  for (const double t : {seam.start_time() + 1e-4, 13 - 1e-4})
    EXPECT_LT(velocity(seam, t).norm(), 1e-8);
  for (const double t : {seam.start_time() + 2e-3, 13 - 2e-3})
    EXPECT_LT(acceleration(seam, t).norm(), 1e-3);
}

/// Velocity, acceleration and rate of turn go on over the ends of an arc, within the run's widths
/// of differences.
TEST(RunIn, JoinsAnArcSmoothly) {
  SeamDescription description = describe({quarter_arc()});
  description.run_in = away({0.02, 0, -0.01});
  description.run_out = away({0.02, 0.01, -0.01});
  const Seam seam = build(description).seam;
  EXPECT_NEAR(seam.pieces()[1].end_time, 0.1 * 90 * kDegree / 0.01, 1e-9);
  for (const double t : {0.0, seam.pieces()[1].end_time}) {
    EXPECT_LT((velocity(seam, t - 1e-3) - velocity(seam, t + 1e-3)).norm(), 3e-6);
    EXPECT_LT((acceleration(seam, t - 5e-3) - acceleration(seam, t + 5e-3)).norm(), 2e-4);
    EXPECT_GT(acceleration(seam, t + (t > 0 ? -5e-3 : 5e-3)).norm(), 0.9e-3);  // v^2 / r
    EXPECT_LT((turn_rate(seam, t - 1e-3) - turn_rate(seam, t + 1e-3)).norm(), 1e-4);
    EXPECT_NEAR(turn_rate(seam, t).norm(), 0.1, 1e-4);
  }
  EXPECT_LT(turn_rate(seam, seam.start_time() + 1e-3).norm(), 1e-4);
  EXPECT_LT(turn_rate(seam, seam.end_time() - 1e-3).norm(), 1e-4);
}

TEST(RunIn, StraightOneOfAnArcIsStraight) {
  SeamDescription description = describe({quarter_arc()});
  description.run_in = along(0.01);
  description.run_out = along(0.01);
  const Seam seam = build(description).seam;
  for (const double f : test::steps(0, 1, 0.1)) {
    EXPECT_NEAR(seam.pieces()[0].frame_at(f).translation().x(), 0.1, 1e-15);
    EXPECT_NEAR(seam.pieces()[2].frame_at(f).translation().y(), 0.1, 1e-15);
  }
  EXPECT_NEAR(seam.pieces()[0].length(), 0.01, 1e-12);
  EXPECT_LT((velocity(seam, -1e-3) - velocity(seam, 1e-3)).norm(), 3e-6);
}

TEST(RunIn, TogetherWithStops) {
  SeamDescription description = describe({line(turned_at(0, 0, 0), turned_at(0.1, 0, 0)),
                                          line(turned_at(0.1, 0, 1), turned_at(0.1, 0.1, 1))});
  description.corners.kind = CornerOptions::Kind::stop;
  description.run_in = along(0.01);
  description.run_out = along(0.01);
  const Task task = build(description);
  EXPECT_TRUE(task.seam.is_retimed());
  EXPECT_NEAR(task.seam.start_time(), -2, 1e-12);
  EXPECT_NEAR(task.seam.nominal_time(0), 0, 1e-12);
  for (const Waypoint& waypoint : task.waypoints)
    EXPECT_LT((task.seam.frame_at(waypoint.time).matrix() - waypoint.frame.matrix()).norm(), 1e-12);
  const double turning = 15.0 / 8.0 / (30 * kDegree);
  EXPECT_NEAR(task.seam.end_time(), 20 + 0.5 + turning + 2, 1e-9);
  EXPECT_FALSE(task.waypoints.front().welding);
  EXPECT_FALSE(task.waypoints.back().welding);
}

TEST(RunIn, WhereAWholeSegmentIsRoundedOff) {
  SeamDescription description =
      describe({line(at(0, 0, 0), at(0.01, 0, 0)), line(at(0.01, 0, 0), at(0.01, 0.1, 0))});
  description.corners.kind = CornerOptions::Kind::blend;
  description.corners.distance = 0.01;
  description.run_in = along(0.01);
  const Seam seam = build(description).seam;
  EXPECT_EQ(seam.pieces().size(), 3U);
  EXPECT_LT((velocity(seam, -1e-3) - velocity(seam, 1e-3)).norm(), 1e-6);
}

TEST(RunIn, NumberOfWaypointsIsThatOfTheWeld) {
  SeamDescription description = describe({line(at(0, 0, 0), at(0.1, 0, 0))});
  description.spacing.reset();
  description.waypoints = 11;
  description.run_in = along(0.03);
  const Task task = build(description);
  int welding = 0;
  for (const Waypoint& waypoint : task.waypoints) welding += waypoint.welding;
  EXPECT_EQ(welding, 11);
  EXPECT_EQ(task.waypoints.size(),
            11U + 6U);  // every 10 mm as on the weld, at twice the mean speed
}

TEST(RunIn, BadRunsAreNamed) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {0.0, -0.01, nan}) {
    SeamDescription description = describe({line(at(0, 0, 0), at(0.1, 0, 0))});
    description.run_in = along(bad);
    EXPECT_TRUE(says(invalid_input([&] { build(description); }), "get up to speed"));
    description.run_in = away({0, 0, -0.01});
    description.run_in->duration = bad;
    EXPECT_TRUE(says(invalid_input([&] { build(description); }), "duration"));
  }
  SeamDescription description = describe({line(at(0, 0, 0), at(0.1, 0, 0))});
  description.run_out = away({0, 0, 0});
  EXPECT_TRUE(says(invalid_input([&] { build(description); }), "get up to speed"));
}

TEST(RunIn, JointWaypointsAtTheEndsHaveNone) {
  JointVector q(3);
  q << 0.1, 0.1, 0.1;
  const Segment joints{JointListSegment{{JointBox(q)}, {"away"}}, {}, "joints"};
  SeamDescription description = describe({line(at(0, 0, 0), at(0.1, 0, 0)), joints});
  description.run_in = along(0.01);
  EXPECT_NO_THROW(build(description));
  description.run_out = along(0.01);
  EXPECT_TRUE(says(invalid_input([&] { build(description); }), "joint waypoint"));
  description = describe({joints, line(at(0, 0, 0), at(0.1, 0, 0))});
  description.run_in = along(0.01);
  EXPECT_TRUE(says(invalid_input([&] { build(description); }), "joint waypoint"));
}

}  // namespace
}  // namespace wristwise
