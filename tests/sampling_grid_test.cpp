#include "graph/sampling_grid.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace wristwise
