#include "smoothing/straight_time.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "recording.hpp"

namespace wristwise {
namespace {

constexpr double kPosition = 5e-4, kAngle = 0.01;

std::vector<Pose> circle(const std::vector<double>& times, double radius, double rate) {
  std::vector<Pose> poses;
  for (const double t : times)
    poses.emplace_back(
        Eigen::Translation3d(radius * std::cos(rate * t), radius * std::sin(rate * t), 0.3));
  return poses;
}

/// radius (1 - cos(rate t / 2)) = kPosition
double sagitta_time(double radius, double rate) {
  return 2 * std::acos(1 - kPosition / radius) / rate;
}

TEST(StraightTime, OnACircleIsThatOfTheSagitta) {
  for (const bool jitter : {false, true}) {
    const auto times = test::recording_times(20000, jitter ? 0.01 : 0.002, jitter);
    const double expected = sagitta_time(0.1, 1.3);
    const double found = straight_time(times, circle(times, 0.1, 1.3), kPosition, kAngle).time;
    EXPECT_LE(found, 1.05 * expected);
    EXPECT_GE(found, 0.8 * expected);
  }
}

TEST(StraightTime, OfATurnOnTheSpotFollowsTheAngle) {
  const auto times = test::recording_times(4000, 0.005);
  std::vector<Pose> poses;
  for (const double t : times)
    poses.emplace_back(Eigen::AngleAxisd(0.2 * std::sin(2 * t), Eigen::Vector3d::UnitX()));
  const double found = straight_time(times, poses, kPosition, kAngle).time;
  // |angle''| <= 0.8 rad/s^2, and the middle is off by |angle''| t^2 / 8.
  EXPECT_GE(found, 0.5 * std::sqrt(8 * kAngle / 0.8));
  EXPECT_LE(found, 2 * std::sqrt(8 * kAngle / 0.8));
}

TEST(StraightTime, AlongALineIsAQuarterOfTheDuration) {
  const auto times = test::recording_times(100, 0.01);
  std::vector<Pose> poses;
  for (const double t : times) poses.emplace_back(Eigen::Translation3d(0.1 * t, 0, 0));
  EXPECT_DOUBLE_EQ(straight_time(times, poses, kPosition, kAngle).time, 0.25 * times.back());
}

TEST(StraightTime, OfTwoPointsIsAQuarterOfTheDuration) {
  EXPECT_DOUBLE_EQ(straight_time({1, 3}, {Pose::Identity(), Pose(Eigen::Translation3d(1, 0, 0))},
                                 kPosition, kAngle)
                       .time,
                   0.5);
}

TEST(StraightTime, IsNeverShorterThanTwoAndAHalfSteps) {
  const auto times = test::recording_times(1000, 0.01);
  const StraightTime found = straight_time(times, circle(times, 0.5, 60), kPosition, kAngle);
  EXPECT_NEAR(found.time, 0.025, 1e-9);
  EXPECT_FALSE(found.straight);
  EXPECT_TRUE(straight_time(times, circle(times, 0.5, 1), kPosition, kAngle).straight);
}

}  // namespace
}  // namespace wristwise
