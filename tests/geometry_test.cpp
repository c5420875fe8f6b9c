#include "wristwise/geometry.hpp"

#include <gtest/gtest.h>

#include "collision_samples.hpp"

namespace wristwise {
namespace {

using test::contains;
using test::random_geometry;
using test::random_unit;
using test::reach;

class EveryKind : public ::testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Kinds, EveryKind, ::testing::Values(0, 1, 2, 3));

TEST_P(EveryKind, SupportPointIsInTheShapeAndNoPointLiesFarther) {
  std::mt19937 random(1);
  for (int sample = 0; sample < 2000; ++sample) {
    const Geometry geometry = random_geometry(random, GetParam());
    const Eigen::Vector3d direction = random_unit(random);
    const Eigen::Vector3d point = support_point(geometry, direction);
    EXPECT_TRUE(contains(geometry, point, 1e-12));
    EXPECT_NEAR(point.dot(direction), reach(geometry, Pose::Identity(), direction), 1e-12);
  }
}

TEST_P(EveryKind, SupportPointDoesNotDependOnTheLengthOfTheDirection) {
  std::mt19937 random(2);
  for (int sample = 0; sample < 200; ++sample) {
    const Geometry geometry = random_geometry(random, GetParam());
    const Eigen::Vector3d direction = random_unit(random);
    const Eigen::Vector3d point = support_point(geometry, direction);
    EXPECT_LT((support_point(geometry, 1e6 * direction) - point).norm(), 1e-12);
    EXPECT_LT((support_point(geometry, 1e-6 * direction) - point).norm(), 1e-12);
  }
}

TEST_P(EveryKind, SupportPointIsFiniteAlongAxesAndForNoDirection) {
  std::mt19937 random(3);
  const Geometry geometry = random_geometry(random, GetParam());
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 0.0, 1.0}) {
      const Eigen::Vector3d direction = sign * Eigen::Vector3d::Unit(axis);
      const Eigen::Vector3d point = support_point(geometry, direction);
      EXPECT_TRUE(contains(geometry, point, 1e-12));
      EXPECT_NEAR(point.dot(direction), reach(geometry, Pose::Identity(), direction), 1e-12);
    }
  }
}

TEST_P(EveryKind, BoundingRadiusIsReachedAndNotExceeded) {
  std::mt19937 random(4);
  for (int sample = 0; sample < 20; ++sample) {
    const Geometry geometry = random_geometry(random, GetParam());
    const double radius = bounding_radius(geometry);
    double farthest = 0;
    for (int i = 0; i < 2000; ++i) {
      const Eigen::Vector3d point = support_point(geometry, random_unit(random));
      farthest = std::max(farthest, point.norm());
    }
    EXPECT_LE(farthest, radius + 1e-12);
    EXPECT_GE(farthest, radius * 0.999);
  }
}

TEST(BoundingBall, OfAHullFarFromItsOriginIsSmallAndHoldsIt) {
  std::mt19937 random(5);
  ConvexHull hull = test::random_hull(random);
  for (auto& vertex : hull.vertices) vertex += Eigen::Vector3d(10, -20, 30);
  const BoundingBall ball = bounding_ball(hull);
  EXPECT_LT(ball.radius, 0.6);
  EXPECT_GT(bounding_radius(hull), 30);
  for (const auto& vertex : hull.vertices) {
    EXPECT_LE((vertex - ball.center).norm(), ball.radius + 1e-12);
  }
}

}  // namespace
}  // namespace wristwise
