// Signed distances against two collision libraries. FCL is asked for separated shapes only, where
// it is sound; Bullet for both.

#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/CollisionShapes/btCylinderShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/convex.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/distance.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "collision_samples.hpp"

namespace wristwise {
namespace {

using test::random_pair;
using test::ShapePair;

std::shared_ptr<fcl::CollisionGeometryd> to_fcl(const Geometry& geometry) {
  if (const auto* box = std::get_if<Box>(&geometry)) return std::make_shared<fcl::Boxd>(box->size);
  if (const auto* sphere = std::get_if<Sphere>(&geometry)) {
    return std::make_shared<fcl::Sphered>(sphere->radius);
  }
  if (const auto* cylinder = std::get_if<Cylinder>(&geometry)) {
    return std::make_shared<fcl::Cylinderd>(cylinder->radius, cylinder->length);
  }
  const auto& hull = std::get<ConvexHull>(geometry);
  auto vertices = std::make_shared<std::vector<Eigen::Vector3d>>(hull.vertices);
  auto faces = std::make_shared<std::vector<int>>();
  for (const auto& [i, j, k] : hull.triangles) faces->insert(faces->end(), {3, i, j, k});
  return std::make_shared<fcl::Convexd>(vertices, static_cast<int>(hull.triangles.size()), faces);
}

double fcl_distance(const ShapePair& pair) {
  const auto a = to_fcl(pair.a), b = to_fcl(pair.b);
  const fcl::DistanceRequestd request(true, false, 0, 0, 1e-9);
  fcl::DistanceResultd result;
  return fcl::distance(a.get(), pair.pose_a, b.get(), pair.pose_b, request, result);
}

btVector3 to_bullet(const Eigen::Vector3d& v) {
  return {static_cast<btScalar>(v.x()), static_cast<btScalar>(v.y()), static_cast<btScalar>(v.z())};
}

btTransform to_bullet(const Pose& pose) {
  const Eigen::Quaterniond q(pose.linear());
  return btTransform(btQuaternion(static_cast<btScalar>(q.x()), static_cast<btScalar>(q.y()),
                                  static_cast<btScalar>(q.z()), static_cast<btScalar>(q.w())),
                     to_bullet(Eigen::Vector3d(pose.translation())));
}

std::unique_ptr<btConvexShape> to_bullet(const Geometry& geometry) {
  std::unique_ptr<btConvexShape> shape;
  if (const auto* box = std::get_if<Box>(&geometry)) {
    shape = std::make_unique<btBoxShape>(to_bullet(Eigen::Vector3d(box->size / 2)));
  } else if (const auto* sphere = std::get_if<Sphere>(&geometry)) {
    // Its margin is its radius.
    return std::make_unique<btSphereShape>(static_cast<btScalar>(sphere->radius));
  } else if (const auto* cylinder = std::get_if<Cylinder>(&geometry)) {
    const Eigen::Vector3d half(cylinder->radius, cylinder->radius, cylinder->length / 2);
    shape = std::make_unique<btCylinderShapeZ>(to_bullet(half));
  } else {
    auto hull = std::make_unique<btConvexHullShape>();
    for (const auto& vertex : std::get<ConvexHull>(geometry).vertices) {
      hull->addPoint(to_bullet(vertex), false);
    }
    hull->recalcLocalAabb();
    shape = std::move(hull);
  }
  shape->setMargin(0);
  return shape;
}

double bullet_distance(const ShapePair& pair) {
  const auto a = to_bullet(pair.a), b = to_bullet(pair.b);
  btVoronoiSimplexSolver simplex;
  btGjkEpaPenetrationDepthSolver depth;
  btGjkPairDetector detector(a.get(), b.get(), &simplex, &depth);
  btGjkPairDetector::ClosestPointInput input;
  input.m_transformA = to_bullet(pair.pose_a);
  input.m_transformB = to_bullet(pair.pose_b);
  btPointCollector output;
  detector.getClosestPoints(input, output, nullptr);
  return output.m_hasResult ? static_cast<double>(output.m_distance) : -1e9;
}

double quantile(std::vector<double>& values, double part) {
  std::sort(values.begin(), values.end());
  return values.at(static_cast<std::size_t>(part * static_cast<double>(values.size() - 1)));
}

class EveryPair : public ::testing::TestWithParam<int> {
 protected:
  ShapePair next(double half_width) {
    return random_pair(random_, GetParam() / 4, GetParam() % 4, half_width);
  }
  bool with_cylinder() const { return GetParam() / 4 == 2 || GetParam() % 4 == 2; }
  std::mt19937 random_{61};
};
INSTANTIATE_TEST_SUITE_P(Kinds, EveryPair, ::testing::Range(0, 16));

// FCL's own answers are off by more than 1e-6 in one of 2000 at this tolerance, so a few may
// differ.
TEST_P(EveryPair, SeparatedDistanceIsThatOfFcl) {
  std::vector<double> errors;
  while (errors.size() < 1000) {
    const ShapePair pair = next(0.6);
    const double distance = pair.measure().distance;
    if (distance > 1e-4) errors.push_back(std::abs(distance - fcl_distance(pair)));
  }
  EXPECT_LT(quantile(errors, 1), 1e-6);
}

// Bullet computes in single precision, and both its searches end early on curved surfaces: there it
// is the inaccurate one (the answers compared are proved in distance_test).
TEST_P(EveryPair, SeparatedDistanceIsThatOfBullet) {
  std::vector<double> errors;
  while (errors.size() < 1000) {
    const ShapePair pair = next(0.6);
    const double distance = pair.measure().distance;
    if (distance > 1e-2) errors.push_back(std::abs(distance - bullet_distance(pair)));
  }
  EXPECT_LT(quantile(errors, 0.5), with_cylinder() ? 2e-4 : 1e-7);
  EXPECT_LT(quantile(errors, 0.95), with_cylinder() ? 3e-3 : 1e-6);
}

TEST_P(EveryPair, PenetrationIsThatOfBullet) {
  std::vector<double> errors;
  while (errors.size() < 1000) {
    const ShapePair pair = next(0.2);
    const double distance = pair.measure().distance;
    if (distance < -1e-2) errors.push_back(std::abs(distance - bullet_distance(pair)));
  }
  EXPECT_LT(quantile(errors, 0.5), with_cylinder() ? 3e-4 : 1e-7);
  EXPECT_LT(quantile(errors, 0.95), with_cylinder() ? 4e-3 : 1e-4);
}

}  // namespace
}  // namespace wristwise
