#include "graph/sampling_grid.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "invalid_input.hpp"

namespace wristwise {
namespace {

constexpr double kDegree = M_PI / 180;
constexpr double kFree = ToleranceBox::kFree;

void expect_samples(const std::vector<double>& found, const std::vector<double>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-12);
}

TEST(CoordinateSamples, IncludeBothEndsOfABoundedRange) {
  expect_samples(coordinate_samples(-0.1, 0.1, 0.05), {-0.1, -0.05, 0, 0.05, 0.1});
  expect_samples(coordinate_samples(0.1, 0.4, 0.1),
                 {0.1, 0.2, 0.3, 0.4});  // round-off in 0.3 / 0.1
}

TEST(CoordinateSamples, AddTheNominalWhereItIsOffTheGrid) {
  expect_samples(coordinate_samples(-0.1, 0.2, 0.15), {-0.1, 0, 0.05, 0.2});
  expect_samples(coordinate_samples(-0.3, 0.3, 0.25), {-0.3, -0.1, 0, 0.1, 0.3});
  expect_samples(coordinate_samples(-1, 2, 100), {-1, 0, 2});
  expect_samples(coordinate_samples(1, 2, 1), {1, 2});
}

TEST(CoordinateSamples, OfAFreeAngleAreEvenlySpread) {
  const auto samples = coordinate_samples(-kFree, kFree, 1 * kDegree);
  ASSERT_EQ(samples.size(), 360U);
  EXPECT_DOUBLE_EQ(samples.front(), -M_PI);
  EXPECT_NEAR(samples[180], 0, 1e-12);
  EXPECT_NEAR(samples.back(), M_PI - kDegree, 1e-12);
  EXPECT_EQ(coordinate_samples(-kFree, kFree, 100 * kDegree).size(), 4U);
  EXPECT_EQ(coordinate_samples(-kFree, kFree, 0).size(), 36U);
}

TEST(CoordinateSamples, OfAnExactCoordinateAreItsValue) {
  expect_samples(coordinate_samples(0.2, 0.2, 0.1), {0.2});
}

TEST(SamplingGrid, IsTheProductOfItsCoordinates) {
  ToleranceBox box;
  box.lower << 0, 0, -0.002, -10 * kDegree, 0, -kFree;
  box.upper << 0, 0, 0.002, 10 * kDegree, 0, kFree;
  Vector6 step;
  step << 0, 0, 0.001, 5 * kDegree, 0, 10 * kDegree;
  const auto grid = sampling_grid(box, step);
  EXPECT_EQ(grid.size(), 5U * 5U * 36U);
  for (const Vector6& e : grid) EXPECT_EQ(box_excess(box, e).maxCoeff(), 0);
}

JointVector joints(double a, double b, double c) {
  JointVector q(3);
  q << a, b, c;
  return q;
}

/// 1.2 to 2 in steps of at most 0.3: three intervals, and the middle 1.6 is kept; the second joint
/// has no step; the third has one value.
TEST(JointGrid, IsTheProductOfTheRanges) {
  const JointBox box(joints(1.2, -0.5, 0.7), joints(2, 0.1, 0.7));
  const auto grid = joint_grid(box, {0.3, 0, 0.1});
  std::vector<JointVector> expected;
  for (const double a : {1.2, 1.2 + 0.8 / 3, 1.6, 1.2 + 1.6 / 3, 2.0}) {
    for (const double b : {-0.5, -0.2, 0.1}) expected.push_back(joints(a, b, 0.7));
  }
  ASSERT_EQ(grid.size(), expected.size());
  for (std::size_t i = 0; i < grid.size(); ++i) {
    EXPECT_LT((grid[i] - expected[i]).cwiseAbs().maxCoeff(), 1e-15) << i;
  }
  // Ends and exact values to the bit: a limit may be there.
  EXPECT_EQ(grid.front(), box.lower);
  EXPECT_EQ(grid.back(), box.upper);
}

TEST(JointGrid, WithoutStepsHasEndsAndMiddle) {
  EXPECT_EQ(joint_grid({joints(0, 1, 2), joints(1, 2, 3)}, {}).size(), 27U);
  const JointVector posture = joints(0.1, 0.2, 0.3);
  const auto exact = joint_grid(posture, {});
  ASSERT_EQ(exact.size(), 1U);
  EXPECT_EQ(exact[0], posture);
}

TEST(JointGrid, RefusesImpossibleSteps) {
  const JointBox box(joints(0, 0, 0), joints(1, 1, 1));
  const auto message = [&](const std::vector<double>& step) {
    return test::invalid_input([&] { joint_grid(box, step); });
  };
  EXPECT_TRUE(test::says(message({0.1, 0.1}), "graph.samples.joints: 2 steps"));
  EXPECT_TRUE(test::says(message({0.1, -1, 0.1}), "-1 is no step"));
  EXPECT_TRUE(test::says(message({0.1, std::nan(""), 0.1}), "nan is no step"));
  EXPECT_TRUE(test::says(message({1e-3, 1e-3, 1e-3}), "at most a million"));
}

TEST(SamplingGrid, OfTooManySamplesIsRefused) {
  const auto message = [](double lower, double upper, double step) {
    return test::invalid_input([&] { coordinate_samples(lower, upper, step); });
  };
  EXPECT_TRUE(test::says(message(-kFree, kFree, 1e-9), "at most a million"));
  EXPECT_TRUE(test::says(message(-kFree, kFree, 1e-300), "at most a million"));
  EXPECT_TRUE(test::says(message(-1, 1, 1e-7), "at most a million"));
  ToleranceBox box;
  box.lower << -0.1, -0.1, -0.1, 0, 0, 0;
  box.upper = -box.lower;
  EXPECT_TRUE(test::says(test::invalid_input([&] { sampling_grid(box, Vector6::Constant(1e-3)); }),
                         "at most a million"));
  EXPECT_EQ(sampling_grid(box, Vector6::Constant(0.1)).size(), 27U);
}

TEST(AutomaticStep, GivesAboutTheSamplesAskedFor) {
  ToleranceBox box;
  box.lower << 0, 0, -0.002, -0.3, -0.1, -kFree;
  box.upper = -box.lower;
  for (const int asked : {1, 100, 1000, 20000}) {
    GraphOptions options;
    options.automatic_samples = asked;
    const auto grid = waypoint_grid(box, options);
    if (asked >= 100) {
      EXPECT_LE(grid.size(), static_cast<std::size_t>(asked));
      EXPECT_GE(grid.size(), static_cast<std::size_t>(asked) / 3);
    }
  }
  const Vector6 step = automatic_step(box, 1000);
  EXPECT_EQ(step[3], step[5]);
}

}  // namespace
}  // namespace wristwise
