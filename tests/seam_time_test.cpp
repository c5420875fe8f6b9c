#include <gtest/gtest.h>

#include <random>

#include "invalid_input.hpp"
#include "seam_samples.hpp"
#include "wristwise/seam.hpp"

namespace wristwise {
namespace {

using test::invalid_input;
using test::says;

JointVector number(double value) { return JointVector::Constant(1, value); }

struct Knot {
  double time, nominal, rate, acceleration;
};

Trajectory law(const std::vector<Knot>& knots) {
  std::vector<double> times;
  std::vector<JointVector> nominal, rate, acceleration;
  for (const Knot& knot : knots) {
    times.push_back(knot.time);
    nominal.push_back(number(knot.nominal));
    rate.push_back(number(knot.rate));
    acceleration.push_back(number(knot.acceleration));
  }
  return {times, nominal, rate, acceleration};
}

/// 2 s at full rate, 1 s down to rest at nominal 2.5 s, 1 s up again, 2 s at full rate.
Trajectory stop_law() {
  return law({{0, 0, 1, 0}, {2, 2, 1, 0}, {3, 2.5, 0, 0}, {4, 3, 1, 0}, {6, 5, 1, 0}});
}

/// The area below the smoothstep 3 w^2 - 2 w^3 that the rate of `stop_law` follows.
double nominal_by_hand(double t) {
  const auto rise = [](double w) { return w * w * w - 0.5 * w * w * w * w; };
  if (t <= 2) return t;
  if (t <= 3) return 2.5 - rise(3 - t);
  if (t <= 4) return 2.5 + rise(t - 3);
  return t - 1;
}

Pose at(double x, double y) {
  Pose pose = Pose::Identity();
  pose.translation() << x, y, 0;
  return pose;
}

/// An L of 2.5 s and 2.5 s at 0.1 m/s; the second leg is turned by 90 deg about z.
Seam corner_seam() {
  const Eigen::AngleAxisd quarter(0.5 * 3.14159265358979323846, Eigen::Vector3d::UnitZ());
  SeamPiece first, second;
  first.from = at(0, 0);
  first.to = at(0.25, 0);
  first.end_time = 2.5;
  second.from = at(0.25, 0) * quarter;
  second.to = at(0.25, 0.25) * quarter;
  second.start_time = 2.5;
  second.end_time = 5;
  return Seam({first, second});
}

Task corner_task(int intervals) {
  Task task;
  task.seam = corner_seam();
  for (int i = 0; i <= intervals; ++i) {
    Waypoint waypoint;
    waypoint.time = 5.0 * i / intervals;
    waypoint.frame = task.seam.frame_at(waypoint.time);
    task.waypoints.push_back(waypoint);
  }
  return task;
}

TEST(SeamTime, WithoutALawRealTimeIsNominal) {
  const Seam seam = corner_seam();
  EXPECT_FALSE(seam.is_retimed());
  EXPECT_EQ(seam.nominal_time(1.25), 1.25);
  EXPECT_EQ(seam.real_time(1.25), 1.25);
  EXPECT_EQ(seam.speed_ratio(1.25), 1);
}

TEST(SeamTime, FrameIsThatOfTheNominalTime) {
  const Seam nominal = corner_seam();
  const Seam seam = nominal.retimed(stop_law());
  EXPECT_DOUBLE_EQ(seam.start_time(), 0);
  EXPECT_DOUBLE_EQ(seam.end_time(), 6);
  for (int i = 0; i <= 600; ++i) {
    if (i == 300) continue;  // at the corner
    const double t = 0.01 * i;
    EXPECT_NEAR(seam.nominal_time(t), nominal_by_hand(t), 1e-14);
    EXPECT_LT((seam.frame_at(t).matrix() - nominal.frame_at(nominal_by_hand(t)).matrix()).norm(),
              1e-12);
  }
}

TEST(SeamTime, CornerBelongsToThePieceThatEndsThere) {
  const Seam seam = corner_seam().retimed(stop_law());
  const double corner = seam.real_time(2.5);
  EXPECT_EQ(corner, 3);
  EXPECT_EQ(&seam.piece_at(corner), &seam.pieces()[0]);
  EXPECT_EQ(&seam.piece_at(corner + 1e-3), &seam.pieces()[1]);
  EXPECT_LT((seam.frame_at(corner).matrix() - seam.pieces()[0].to.matrix()).norm(), 1e-12);
}

TEST(SeamTime, SpeedRatioIsTheRateOfTheNominalTime) {
  const Seam seam = corner_seam().retimed(stop_law());
  for (const double t : test::steps(0.05, 6, 0.1)) {
    const double numeric = (seam.nominal_time(t + 1e-5) - seam.nominal_time(t - 1e-5)) / 2e-5;
    EXPECT_NEAR(seam.speed_ratio(t), numeric, 1e-8) << t;
  }
  EXPECT_EQ(seam.speed_ratio(3), 0);
  EXPECT_EQ(seam.speed_ratio(1), 1);
}

TEST(SeamTime, RealTimeIsTheInverse) {
  const Seam seam = corner_seam().retimed(stop_law());
  for (const double nominal : test::steps(0, 5, 1.0 / 128)) {
    EXPECT_NEAR(seam.nominal_time(seam.real_time(nominal)), nominal, 1e-14);
  }
  // Where the rate is zero the time is not well determined, the nominal time is.
  for (const double off : {1e-15, 1e-12, 1e-9, 1e-6}) {
    EXPECT_NEAR(seam.nominal_time(seam.real_time(2.5 - off)), 2.5 - off, 1e-14);
    EXPECT_NEAR(seam.nominal_time(seam.real_time(2.5 + off)), 2.5 + off, 1e-14);
  }
}

TEST(SeamTime, RealTimeOfAStandstillIsItsStart) {
  const Trajectory standing = law(
      {{0, 0, 1, 0}, {2, 2, 1, 0}, {3, 2.5, 0, 0}, {9, 2.5, 0, 0}, {10, 3, 1, 0}, {12, 5, 1, 0}});
  const Seam seam = corner_seam().retimed(standing);
  EXPECT_EQ(seam.real_time(2.5), 3);
  EXPECT_EQ(seam.nominal_time(6), 2.5);
  EXPECT_EQ(&seam.piece_at(6), &seam.pieces()[0]);
  EXPECT_EQ(seam.end_time(), 12);
}

TEST(SeamTime, ALawMayRunBeyondTheSeam) {
  const Seam seam = corner_seam().retimed(law({{-1, -1, 1, 0}, {7, 7, 1, 0}}));
  EXPECT_NEAR(seam.start_time(), 0, 1e-14);
  EXPECT_NEAR(seam.end_time(), 5, 1e-14);
}

TEST(SeamTime, RetimingAgainReplacesTheLaw) {
  const Trajectory slow = law({{0, 0, 0.5, 0}, {10, 5, 0.5, 0}});
  const Seam once = corner_seam().retimed(slow);
  const Seam twice = corner_seam().retimed(stop_law()).retimed(slow);
  EXPECT_EQ(twice.end_time(), 10);
  for (const double t : test::steps(0, 10, 0.25))
    EXPECT_EQ(twice.nominal_time(t), once.nominal_time(t));
}

/// Random increasing laws: twice continuously differentiable, exact at the waypoints.
TEST(SeamTime, TaskKeepsItsWaypoints) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> share(0.3, 1);
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<Knot> knots{{100, 0, 1, 0}};
    while (knots.back().nominal < 5) {
      const double rate = share(random), step = 0.4 * share(random);
      knots.push_back({knots.back().time + 2 * step / (rate + knots.back().rate),
                       knots.back().nominal + step, rate, 0});
    }
    const Task task = corner_task(40);
    const Task retimed = task.retimed(law(knots));
    ASSERT_EQ(retimed.waypoints.size(), task.waypoints.size());
    for (std::size_t i = 0; i < task.waypoints.size(); ++i) {
      const Pose there = retimed.seam.frame_at(retimed.waypoints[i].time);
      EXPECT_LT((there.matrix() - task.waypoints[i].frame.matrix()).norm(), 1e-12) << i;
    }
    // Back to the clock of the weld.
    const Task back = retimed.retimed(law({{0, 0, 1, 0}, {5, 5, 1, 0}}));
    for (std::size_t i = 0; i < task.waypoints.size(); ++i)
      EXPECT_NEAR(back.waypoints[i].time, task.waypoints[i].time, 1e-12);
  }
}

TEST(SeamTime, WaypointsAtOtherTimesOfARetimedSeam) {
  const Task task = corner_task(4).retimed(stop_law());
  const Task other = task.with_waypoints_at({0, 2.5, 3, 3.5, 6});
  EXPECT_NEAR(other.waypoints[1].frame.translation().x(), 0.1 * nominal_by_hand(2.5), 1e-14);
  EXPECT_NEAR(other.waypoints[3].frame.translation().y(), 0.1 * nominal_by_hand(3.5) - 0.25, 1e-14);
  EXPECT_TRUE(says(invalid_input([&] { task.with_waypoints_at({0, 6.1}); }), "6.1"));
}

TEST(SeamTime, BoxOfTheRunInHoldsUntilTheWeldStarts) {
  Task task = corner_task(4);
  task.waypoints[0].welding = task.waypoints[4].welding = false;
  task.waypoints[0].tolerance.lower[0] = -1;
  task.waypoints[4].tolerance.lower[0] = -2;
  EXPECT_EQ(task.tolerance_between(0)->lower[0], -1);
  EXPECT_EQ(task.tolerance_between(1)->lower[0], 0);
  EXPECT_EQ(task.tolerance_between(3)->lower[0], -2);
  const Task other = task.with_waypoints_at({0, 0.5, 1.25, 2, 5});
  EXPECT_FALSE(other.waypoints[1].welding);
  EXPECT_EQ(other.waypoints[1].tolerance.lower[0], -1);
  EXPECT_TRUE(other.waypoints[2].welding);
  EXPECT_TRUE(other.waypoints[3].welding);
}

TEST(SeamTime, BadLawsAreNamed) {
  const Seam seam = corner_seam();
  EXPECT_TRUE(says(invalid_input([&] { seam.retimed(Trajectory()); }), "empty"));
  EXPECT_TRUE(says(invalid_input([&] { Seam().retimed(stop_law()); }), "no pieces"));
  const JointVector zero = JointVector::Zero(2), five = JointVector::Constant(2, 5);
  EXPECT_TRUE(says(invalid_input([&] {
                     seam.retimed({{0, 5}, {zero, five}, {zero, zero}, {zero, zero}});
                   }),
                   "2 joints"));
  EXPECT_TRUE(says(invalid_input([&] {
                     seam.retimed(law({{0, 0, 1, 0}, {3, 3, 1, 0}, {4, 2, 1, 0}, {9, 5, 1, 0}}));
                   }),
                   "decreases between 3"));
  // Increasing at all knots, not between them.
  EXPECT_TRUE(says(invalid_input([&] {
                     seam.retimed(law({{0, 0, 3, 0}, {5, 5, 3, 0}}));
                   }),
                   "decreases"));
  EXPECT_TRUE(says(invalid_input([&] {
                     seam.retimed(law({{0, 0, 1, 0}, {4.9, 4.9, 1, 0}}));
                   }),
                   "whole seam"));
  EXPECT_TRUE(says(invalid_input([&] {
                     seam.retimed(law({{0, 0.1, 1, 0}, {5, 5.1, 1, 0}}));
                   }),
                   "whole seam"));
}

}  // namespace
}  // namespace wristwise
