#include "timing/slowed_stretches.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace wristwise {
namespace {

JointVector one(double value) { return JointVector::Constant(1, value); }

/// A law with the given speeds at 0, 1, 2, ... s, the pieces' times by the mean of both.
Trajectory law(const std::vector<double>& speeds) {
  std::vector<double> times;
  std::vector<JointVector> positions, velocities, accelerations;
  double sum = 0;
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    if (i > 0) sum += 0.5 * (speeds[i - 1] + speeds[i]);
    times.push_back(static_cast<double>(i));
    positions.push_back(one(sum));
    velocities.push_back(one(speeds[i]));
    accelerations.push_back(one(0));
  }
  return {times, positions, velocities, accelerations};
}

/// Joint 0 turns at 1 rad/s, joint 1 at 2 rad/s.
Trajectory turning(double duration) {
  const Eigen::Vector2d speed(1, 2), zero(0, 0);
  return {{0, duration}, {zero, speed * duration}, {speed, speed}, {zero, zero}};
}

Rates velocity_limits(double first, double second) {
  Rates limits = Rates::Constant(2, 3, INFINITY);
  limits.col(0) << first, second;
  return limits;
}

TEST(SlowedStretches, NoneAtFullSpeed) {
  EXPECT_TRUE(slowed_stretches(law({1, 1, 1, 1}), turning(3), velocity_limits(1, 2)).empty());
}

TEST(SlowedStretches, AreWhereTheLawIsSlow) {
  const auto stretches =
      slowed_stretches(law({1, 1, 0.4, 0.6, 1, 1, 1, 0.2}), turning(7), velocity_limits(10, 2.5));
  ASSERT_EQ(stretches.size(), 2U);
  EXPECT_EQ(stretches[0].from, 1);
  EXPECT_EQ(stretches[0].to, 4);
  EXPECT_NEAR(stretches[0].least_ratio, 0.4, 0.02);
  EXPECT_EQ(stretches[0].joint, 1);
  EXPECT_EQ(stretches[1].from, 6);
  EXPECT_EQ(stretches[1].to, 7);
  EXPECT_NEAR(stretches[1].least_ratio, 0.2, 0.02);
}

TEST(SlowedStretches, NameTheJointNearestToItsLimit) {
  EXPECT_EQ(slowed_stretches(law({0.5, 0.5}), turning(1), velocity_limits(1.1, 20))[0].joint, 0);
  EXPECT_EQ(slowed_stretches(law({0.5, 0.5}), turning(1), velocity_limits(11, 20))[0].joint, 1);
}

}  // namespace
}  // namespace wristwise
