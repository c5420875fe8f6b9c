#include "collision/hull_reduction.hpp"

#include <gtest/gtest.h>

#include "collision_samples.hpp"
#include "wristwise/mesh.hpp"

namespace wristwise {
namespace {

/// max over directions of how much farther the one reaches than the other; for convex bodies, one
/// in the other, that is the largest distance of a point.
double reach_beyond(const ConvexHull& outer, const ConvexHull& inner, std::mt19937& random) {
  double most = -1e300;
  for (int i = 0; i < 3000; ++i) {
    const Eigen::Vector3d direction = test::random_unit(random);
    most = std::max(most, test::reach(outer, Pose::Identity(), direction) -
                              test::reach(inner, Pose::Identity(), direction));
  }
  return most;
}

ConvexHull hull_of_many(std::mt19937& random, const Eigen::Vector3d& size, bool rounded) {
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 3000; ++i) {
    Eigen::Vector3d point = test::random_unit(random);
    if (!rounded) point = 0.2 * point + 0.8 * point.cwiseSign();  // a box with round edges
    points.emplace_back(point.cwiseProduct(size));
  }
  return convex_hull(points, "points");
}

TEST(ReducedHull, HoldsTheHullAndReachesNoFartherThanAskedFor) {
  std::mt19937 random(91);
  for (const bool rounded : {true, false}) {
    for (const Eigen::Vector3d& size :
         {Eigen::Vector3d(1, 1, 1), Eigen::Vector3d(0.1, 0.05, 0.4), Eigen::Vector3d(1, 1, 0.01)}) {
      const ConvexHull hull = hull_of_many(random, size, rounded);
      const double error = 5e-3 * size.maxCoeff();
      const ConvexHull reduced = reduced_hull(hull, error);
      EXPECT_LT(reduced.vertices.size(), 0.7 * static_cast<double>(hull.vertices.size()));
      for (const Eigen::Vector3d& vertex : hull.vertices) {
        ASSERT_TRUE(test::contains(reduced, vertex, 2e-9 * size.maxCoeff()));
      }
      EXPECT_LE(reach_beyond(reduced, hull, random), error * (1 + 1e-9));
    }
  }
}

TEST(ReducedHull, LeavesAloneWhatHasNothingToSpare) {
  std::mt19937 random(92);
  const ConvexHull small = test::random_hull(random);
  EXPECT_EQ(reduced_hull(small, 1e-3).vertices, small.vertices);
  const ConvexHull round = hull_of_many(random, {1, 1, 1}, true);
  EXPECT_EQ(reduced_hull(round, 1e-7).vertices, round.vertices);
}

}  // namespace
}  // namespace wristwise
