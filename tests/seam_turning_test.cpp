#include "refine/seam_turning.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "gantry.hpp"

namespace wristwise {
namespace {

namespace gantry = test::gantry;

constexpr double kPi = 3.14159265358979323846;

/// Waypoints at the given times on x(t), y(t).
template <class Path>
Task task_along(const std::vector<double>& times, const Path& path) {
  Task task;
  for (const double t : times) {
    Waypoint waypoint;
    waypoint.time = t;
    waypoint.frame.translation() = path(t);
    task.waypoints.push_back(waypoint);
  }
  return task;
}

std::vector<double> even_times(double end, int count) {
  std::vector<double> times;
  for (int i = 0; i <= count; ++i) times.push_back(end * i / count);
  return times;
}

TEST(SeamTurning, OfACircleIsItsAngle) {
  const Task task = task_along(even_times(2 * kPi, 1000), [](double t) -> Eigen::Vector3d {
    return {std::cos(t), std::sin(t), 0.3};
  });
  const SeamTurning turning(task, 0.05);
  EXPECT_EQ(turning.until(0), 0);
  EXPECT_NEAR(turning.until(3) - turning.until(1), 2, 0.01);
  EXPECT_NEAR(turning.total(), 2 * kPi, 0.1);  // the first and the last half step turn nothing
}

TEST(SeamTurning, OfACornerIsAboutTheCorner) {
  const Task task = gantry::task({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, 20, 20, gantry::box(0, 0));
  const SeamTurning turning(task, 0.1);
  EXPECT_NEAR(turning.total(), kPi / 2, 1e-9);
  EXPECT_NEAR(turning.until(9), 0, 1e-9);
  EXPECT_NEAR(turning.until(10), kPi / 4, 1e-9);
  EXPECT_NEAR(turning.until(11), kPi / 2, 1e-9);
}

TEST(SeamTurning, NeverFallsAndNeverExceedsTheTotal) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-1, 1);
  const Task task = task_along(even_times(10, 100), [&](double) -> Eigen::Vector3d {
    return {place(random), place(random), place(random)};
  });
  const SeamTurning turning(task, 0.3);
  double last = 0;
  for (double t = -1; t < 11; t += 0.01) {
    EXPECT_GE(turning.until(t), last);
    last = turning.until(t);
  }
  EXPECT_EQ(last, turning.total());
}

TEST(SeamTurning, NoiseBelowTheStepIsNone) {
  std::mt19937 random(6);
  std::normal_distribution<double> noise(0, 1e-4);
  const Task task = task_along(even_times(10, 10000), [&](double t) -> Eigen::Vector3d {
    return {t, noise(random), noise(random)};
  });
  EXPECT_GT(SeamTurning(task, 0).total(), 100);
  EXPECT_LT(SeamTurning(task, 0.5).total(), 0.02);
}

TEST(SeamTurning, OfALineAPointOrAStandstillIsNone) {
  const auto line = [](double t) -> Eigen::Vector3d { return {t, -t, 0.5 * t}; };
  EXPECT_NEAR(SeamTurning(task_along(even_times(5, 50), line), 0.2).total(), 0, 1e-6);
  EXPECT_EQ(SeamTurning(task_along({3}, line), 0.2).total(), 0);
  EXPECT_EQ(SeamTurning(task_along({3}, line), 0.2).until(3), 0);
  const auto point = [](double) -> Eigen::Vector3d { return {1, 2, 3}; };
  EXPECT_EQ(SeamTurning(task_along(even_times(5, 50), point), 0.2).total(), 0);
}

}  // namespace
}  // namespace wristwise
