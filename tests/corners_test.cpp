#include "task/corners.hpp"

#include <gtest/gtest.h>

#include <cmath>

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
using Kind = CornerOptions::Kind;

constexpr double kDegree = 0.017453292519943295;

Task build(const SeamDescription& description) {
  return build_task(test::sliding_robot(), description);
}

/// An L of 100 mm and 50 mm; the frame of the second leg is turned by `turn`.
SeamDescription corner(Kind kind, double turn = 0) {
  SeamDescription description =
      describe({line(turned_at(0, 0, 0), turned_at(0.1, 0, 0), "first"),
                line(turned_at(0.1, 0, turn), turned_at(0.1, 0.05, turn), "second")});
  description.corners.kind = kind;
  description.corners.distance = 0.004;
  return description;
}

double speed_at(const Seam& seam, double t) {
  const double h = 1e-6;
  return (seam.frame_at(t + h).translation() - seam.frame_at(t - h).translation()).norm() / (2 * h);
}

double length_between_waypoints(const Task& task) {
  double longest = 0;
  for (std::size_t i = 1; i < task.waypoints.size(); ++i)
    longest = std::max(
        longest,
        (task.waypoints[i].frame.translation() - task.waypoints[i - 1].frame.translation()).norm());
  return longest;
}

/// Waypoints lie on the seam at their times, which increase; none is farther than the spacing.
void expect_sound(const Task& task, double spacing = 0.005) {
  EXPECT_EQ(task.waypoints.front().time, task.seam.start_time());
  EXPECT_NEAR(task.waypoints.back().time, task.seam.end_time(), 1e-12);
  for (std::size_t i = 0; i < task.waypoints.size(); ++i) {
    const Waypoint& waypoint = task.waypoints[i];
    if (i > 0) {
      EXPECT_GT(waypoint.time, task.waypoints[i - 1].time);
    }
    EXPECT_LT((task.seam.frame_at(waypoint.time).matrix() - waypoint.frame.matrix()).norm(), 1e-12)
        << "waypoint " << i << " at " << waypoint.time;
  }
  EXPECT_LE(length_between_waypoints(task), spacing * (1 + 1e-6));
}

TEST(FindCorners, WhereTangentOrFrameJump) {
  const Segment arc = {ArcSegment{at(0.1, 0, 0), {0.1, 0.05, 0}, Eigen::Vector3d::UnitZ(), 1.0},
                       {},
                       "arc"};  // leaves along x
  PoseListSegment list;
  list.poses = {at(0, 0, 0), at(0.1, 0, 0), at(0.2, 0.1, 0), at(0.3, 0.2, 0), at(0.4, 0.30005, 0)};
  list.where = {"0", "1", "2", "3", "4"};
  SeamDescription description = describe({line(at(0, 0, 0), at(0.1, 0, 0)), arc});
  description.corners.kind = Kind::stop;
  EXPECT_FALSE(build(description).seam.is_retimed());  // line and arc go over smoothly

  description = describe({Segment{list, {}, "list"}});
  description.corners.kind = Kind::stop;
  const Task task = build(description);
  // Only where the path bends by 45 deg; that of 0.25 mrad is none.
  const auto& law = task.seam.seam_time();
  int stops = 0;
  for (const JointVector& rate : law.velocities()) stops += rate[0] == 0;
  EXPECT_EQ(stops, 1);
  EXPECT_NEAR(task.seam.speed_ratio(task.seam.real_time(10)), 0, 1e-12);
}

TEST(FindCorners, WhereTheyLieInAngle) {
  for (const double angle : {0.0009, 0.0011}) {
    SeamDescription description = corner(Kind::stop);
    description.segments[1] =
        line(at(0.1, 0, 0), at(0.1 + 0.05 * std::cos(angle), 0.05 * std::sin(angle), 0), "second");
    EXPECT_EQ(build(description).seam.is_retimed(), angle > 1e-3);
    description = corner(Kind::stop, angle);
    description.segments[1] = line(turned_at(0.1, 0, angle), turned_at(0.15, 0, angle), "second");
    EXPECT_EQ(build(description).seam.is_retimed(), angle > 1e-3);
  }
}

TEST(Corners, KeptNothingChanges) {
  const Task task = build(corner(Kind::keep, 90 * kDegree));
  EXPECT_FALSE(task.seam.is_retimed());
  EXPECT_EQ(task.seam.pieces().size(), 2U);
  EXPECT_EQ(task.waypoints.size(), 31U);
  EXPECT_EQ(task.waypoints.back().time, 15);
}

TEST(Corners, WithoutCornerAllKindsGiveTheSame) {
  for (const Kind kind : {Kind::stop, Kind::slow, Kind::blend}) {
    SeamDescription description = describe({line(at(0, 0, 0), at(0.1, 0, 0))});
    const Task plain = build(description);
    description.corners.kind = kind;
    description.corners.distance = 0.004;
    const Task task = build(description);
    EXPECT_FALSE(task.seam.is_retimed());
    ASSERT_EQ(task.waypoints.size(), plain.waypoints.size());
    for (std::size_t i = 0; i < task.waypoints.size(); ++i)
      EXPECT_EQ(task.waypoints[i].time, plain.waypoints[i].time);
  }
}

TEST(CornerStop, RampsDownAndUp) {
  const Task task = build(corner(Kind::stop));
  expect_sound(task);
  const Seam& seam = task.seam;
  EXPECT_EQ(seam.pieces().size(), 2U);
  EXPECT_NEAR(seam.end_time(), 15.5, 1e-12);  // two ramps of 0.5 s, half the way each
  EXPECT_NEAR(seam.real_time(10), 10.25, 1e-12);
  for (const double t : {0.5, 5.0, 9.7, 10.8, 15.0}) EXPECT_NEAR(speed_at(seam, t), 0.01, 1e-9);
  for (const double w : {0.1, 0.3, 0.5, 0.8}) {
    const double step = w * w * (3 - 2 * w);
    EXPECT_NEAR(speed_at(seam, 10.25 - 0.5 * w), 0.01 * step, 1e-9);
    EXPECT_NEAR(speed_at(seam, 10.25 + 0.5 * w), 0.01 * step, 1e-9);
    EXPECT_NEAR(seam.speed_ratio(10.25 + 0.5 * w), step, 1e-12);
  }
  EXPECT_NEAR(seam.speed_ratio(10.25), 0, 1e-12);
}

TEST(CornerStop, EveryKnotOfTheLawIsAWaypoint) {
  const Task task = build(corner(Kind::stop, 90 * kDegree));
  for (const double t : task.seam.seam_time().times()) {
    double nearest = 1;
    for (const Waypoint& waypoint : task.waypoints)
      nearest = std::min(nearest, std::abs(waypoint.time - t));
    EXPECT_LT(nearest, 1e-9) << t;
  }
}

TEST(CornerStop, TorchTurnsWhileItStands) {
  const Task task = build(corner(Kind::stop, 90 * kDegree));
  expect_sound(task);
  const Seam& seam = task.seam;
  ASSERT_EQ(seam.pieces().size(), 3U);
  const double start = seam.real_time(10), end = seam.real_time(13);
  EXPECT_NEAR(end - start, 15.0 / 8.0 * 3, 1e-12);  // 90 deg at 30 deg/s at most
  double fastest = 0;
  for (double t = start + 1e-3; t < end; t += 0.01) {
    EXPECT_LT((seam.frame_at(t).translation() - Eigen::Vector3d(0.1, 0, 0)).norm(), 1e-15);
    const Eigen::AngleAxisd turn(seam.frame_at(t - 1e-4).linear().transpose() *
                                 seam.frame_at(t + 1e-4).linear());
    fastest = std::max(fastest, turn.angle() / 2e-4);
  }
  EXPECT_NEAR(fastest, 30 * kDegree, 1e-4);
  for (const double t : {start, end}) EXPECT_NEAR(seam.speed_ratio(t), 0, 1e-12);
  int waypoints = 0;
  for (const Waypoint& waypoint : task.waypoints)
    waypoints += waypoint.time > start + 1e-6 && waypoint.time <= end + 1e-6;
  EXPECT_EQ(waypoints, 9);  // at most 10 deg each
}

TEST(CornerStop, SpannedTurnTakesNoLongerThanARamp) {
  SeamDescription description = corner(Kind::stop, 90 * kDegree);
  for (Segment& segment : description.segments)
    segment.tolerance.lower[5] = -(segment.tolerance.upper[5] = ToleranceBox::kFree);
  const Task task = build(description);
  expect_sound(task);
  EXPECT_NEAR(task.seam.end_time(), 15.5 + 0.5, 1e-12);
}

TEST(CornerStop, LowersThePeakWhereRampsMeet) {
  SeamDescription description =
      describe({line(at(0, 0, 0), at(0.1, 0, 0)), line(at(0.1, 0, 0), at(0.1, 0.002, 0)),
                line(at(0.1, 0.002, 0), at(0.2, 0.002, 0))});
  description.corners.kind = Kind::stop;
  const Task task = build(description);
  expect_sound(task);
  // 0.2 s at weld speed between two ramps of 0.5 s: they reach 0.2 / 0.5 of it.
  const double middle = task.seam.real_time(10.1);
  EXPECT_NEAR(task.seam.speed_ratio(middle), 0.4, 1e-9);
  EXPECT_NEAR(task.seam.real_time(10.2) - task.seam.real_time(10), 1, 1e-12);
}

TEST(CornerStop, RampMustFitWhereTheSeamStartsAtSpeed) {
  SeamDescription description = corner(Kind::stop);
  description.segments[0] = line(at(0.0977, 0, 0), at(0.1, 0, 0), "first");
  const std::string message = invalid_input([&] { build(description); });
  EXPECT_TRUE(says(message, "first") && says(message, "too short for a ramp")) << message;
  description.segments[0] = line(at(0.0975, 0, 0), at(0.1, 0, 0), "first");
  EXPECT_NEAR(build(description).seam.real_time(0.25), 0.5, 1e-12);
}

TEST(CornerStop, BesideTimedPosesAndTurnsOnTheSpot) {
  PoseListSegment list;
  list.poses = {at(0, 0, 0), at(0.1, 0, 0), turned_at(0.1, 0, 1), turned_at(0.1, 0.1, 1)};
  list.times = {2, 12, 16, 36};
  list.where = {"0", "1", "2", "3"};
  SeamDescription description = describe({Segment{list, {}, "list"}});
  description.corners.kind = Kind::stop;
  const Task task = build(description);
  expect_sound(task);
  EXPECT_EQ(task.seam.start_time(), 2);
  EXPECT_NEAR(task.seam.end_time(), 36 + 4 * 0.25, 1e-12);
  description.corners.kind = Kind::blend;
  description.corners.distance = 0.004;
  EXPECT_TRUE(says(invalid_input([&] { build(description); }), "turn on the spot"));
}

TEST(CornerSlow, FallsToTheRatio) {
  SeamDescription description = corner(Kind::slow);
  description.corners.speed_ratio = 0.25;
  description.corners.ramp_time = 1;
  const Task task = build(description);
  expect_sound(task);
  EXPECT_NEAR(task.seam.speed_ratio(task.seam.real_time(10)), 0.25, 1e-12);
  // On each side (1 + 0.25) / 2 s of nominal time take 1 s.
  EXPECT_NEAR(task.seam.end_time(), 15 + 2 * 0.375, 1e-12);
  double slowest = 1;
  for (double t = 0; t < task.seam.end_time(); t += 0.01)
    slowest = std::min(slowest, task.seam.speed_ratio(t));
  EXPECT_NEAR(slowest, 0.25, 1e-3);
}

TEST(CornerSlow, NeedsATurnThatTheToleranceSpans) {
  SeamDescription description = corner(Kind::slow, 20 * kDegree);
  const std::string message = invalid_input([&] { build(description); });
  EXPECT_TRUE(says(message, "second") && says(message, "20 deg") && says(message, "stop or blend"))
      << message;
  description.segments[0].tolerance.upper[5] = 25 * kDegree;
  EXPECT_TRUE(says(invalid_input([&] { build(description); }), "tolerance spans"));
  description.segments[1].tolerance.lower[5] = -25 * kDegree;
  EXPECT_NO_THROW(build(description));
}

TEST(CornerBlending, RoundsOffAtConstantSpeed) {
  const Task task = build(corner(Kind::blend, 90 * kDegree));
  expect_sound(task);
  const Seam& seam = task.seam;
  EXPECT_FALSE(seam.is_retimed());
  ASSERT_EQ(seam.pieces().size(), 3U);
  EXPECT_EQ(seam.pieces()[1].kind, SeamPiece::Kind::curve);
  EXPECT_NEAR(seam.pieces()[0].length(), 0.096, 1e-15);
  EXPECT_NEAR(seam.pieces()[2].length(), 0.046, 1e-15);
  EXPECT_LT((seam.pieces()[1].from.translation() - Eigen::Vector3d(0.096, 0, 0)).norm(), 1e-15);
  for (double t = 0.01; t < seam.end_time(); t += 0.01)
    EXPECT_NEAR(speed_at(seam, t), 0.01, 1e-8) << t;
  // Nowhere farther from the corner than the curve's apex, and within the triangle of its ends.
  double nearest = 1;
  for (double t = 0; t < seam.end_time(); t += 0.001)
    nearest =
        std::min(nearest, (seam.frame_at(t).translation() - Eigen::Vector3d(0.1, 0, 0)).norm());
  EXPECT_NEAR(nearest, 0.004 * std::sqrt(2.0) * (1 + 2.5) / 32, 1e-6);
}

TEST(CornerBlending, MayUseUpASegment) {
  SeamDescription description =
      describe({line(at(0, 0, 0), at(0.1, 0, 0)), line(at(0.1, 0, 0), at(0.1, 0.008, 0)),
                line(at(0.1, 0.008, 0), at(0.2, 0.008, 0), "third")});
  description.corners.kind = Kind::blend;
  description.corners.distance = 0.004;
  const Task task = build(description);
  expect_sound(task);
  EXPECT_EQ(task.seam.pieces().size(), 4U);  // line, blend, blend, line
  for (double t = 0.01; t < task.seam.end_time(); t += 0.01)
    EXPECT_NEAR(speed_at(task.seam, t), 0.01, 1e-7) << t;
  description.corners.distance = 0.0041;
  const std::string message = invalid_input([&] { build(description); });
  EXPECT_TRUE(says(message, "corner at the start of") && says(message, "does not fit")) << message;
}

TEST(CornerBlending, KeepsTheTimesOfPosesThatHaveThem) {
  PoseListSegment list;
  list.poses = {at(0, 0, 0), at(0.1, 0, 0), at(0.1, 0.1, 0)};
  list.times = {0, 10, 30};
  list.where = {"0", "1", "2"};
  SeamDescription description = describe({Segment{list, {}, "list"}});
  description.corners.kind = Kind::blend;
  description.corners.distance = 0.01;
  const Seam seam = build(description).seam;
  EXPECT_NEAR(seam.end_time(), 30, 1e-12);
  EXPECT_NEAR(seam.pieces()[1].start_time, 9, 1e-12);
  EXPECT_NEAR(seam.pieces()[1].end_time, 12, 1e-12);
}

TEST(CornerBlending, BetweenArcsAndLines) {
  // Down along an arc of 50 mm that ends at (0.05, 0), then straight on to the left.
  const Segment arc = {
      ArcSegment{at(0, 0.05, 0), {0, 0, 0}, -Eigen::Vector3d::UnitZ(), 90 * kDegree}, {}, "arc"};
  SeamDescription description = describe({arc, line(at(0.05, 0, 0), at(0, 0, 0), "back")});
  description.corners.kind = Kind::blend;
  description.corners.distance = 0.01;
  // The arc's frame is turned along with it.
  Pose turned = turned_at(0.05, 0, -90 * kDegree), far = turned_at(0, 0, -90 * kDegree);
  description.segments[1] = line(turned, far, "back");
  const Task task = build(description);
  expect_sound(task);
  for (double t = 0.01; t < task.seam.end_time(); t += 0.01)
    EXPECT_NEAR(speed_at(task.seam, t), 0.01, 1e-7) << t;
  const Eigen::Vector3d start = task.seam.pieces()[1].from.translation();
  EXPECT_NEAR(start.norm(), 0.05, 1e-12);
  EXPECT_NEAR(std::atan2(start.y(), start.x()), 0.01 / 0.05, 1e-12);
  description.corners.distance = 0.051;
  description.segments[1] = line(turned, turned_at(-0.1, 0, -90 * kDegree), "back");
  EXPECT_TRUE(says(invalid_input([&] { build(description); }), "smaller radius"));
}

TEST(CornerBlending, ReverseCornersCanNotBeRoundedOff) {
  SeamDescription description = corner(Kind::blend);
  description.segments[1] = line(at(0.1, 0, 0), at(0.05, 0, 0), "second");
  const std::string message = invalid_input([&] { build(description); });
  EXPECT_TRUE(says(message, "second") && says(message, "180 deg") && says(message, "too sharp"))
      << message;
  description.corners.kind = Kind::stop;
  EXPECT_NO_THROW(build(description));
}

TEST(Corners, NumberOfWaypointsIsKept) {
  for (const Kind kind : {Kind::stop, Kind::slow, Kind::blend}) {
    SeamDescription description = corner(kind);
    description.spacing.reset();
    description.waypoints = 40;
    const Task task = build(description);
    EXPECT_EQ(task.waypoints.size(), 40U);
    expect_sound(task, 0.006);
    description.waypoints = 3;
    EXPECT_TRUE(says(invalid_input([&] { build(description); }), "too few"));
  }
}

TEST(Corners, BadOptionsAreNamed) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {0.0, -1.0, nan}) {
    SeamDescription description = corner(Kind::stop);
    description.corners.ramp_time = bad;
    EXPECT_TRUE(says(invalid_input([&] { build(description); }), "ramp time"));
    description = corner(Kind::stop);
    description.corners.turn_rate = bad;
    EXPECT_TRUE(says(invalid_input([&] { build(description); }), "turn rate"));
    description = corner(Kind::slow);
    description.corners.speed_ratio = bad;
    EXPECT_TRUE(says(invalid_input([&] { build(description); }), "speed ratio"));
    description = corner(Kind::blend);
    description.corners.distance = bad;
    EXPECT_TRUE(says(invalid_input([&] { build(description); }), "distance"));
  }
}

TEST(Corners, MovesToJointWaypointsHaveNone) {
  SeamDescription description = corner(Kind::stop);
  JointVector q(3);
  q << 0.1, 0.1, 0.1;
  description.segments.push_back({JointListSegment{{JointBox(q)}, {"away"}}, {}, "joints"});
  const Task task = build(description);
  EXPECT_TRUE(task.waypoints.back().joints);
  EXPECT_EQ(task.seam.pieces().back().kind, SeamPiece::Kind::move);
  EXPECT_NEAR(task.seam.speed_ratio(task.waypoints.back().time), 1, 1e-12);
  EXPECT_FALSE(task.tolerance_between(task.waypoints.size() - 2));
}

}  // namespace
}  // namespace wristwise
