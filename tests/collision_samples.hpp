#pragma once

#include <cmath>
#include <random>

#include "collision/signed_distance.hpp"

namespace wristwise::test {

constexpr double kPi = 3.14159265358979323846;

inline double uniform(std::mt19937& random, double lower, double upper) {
  return std::uniform_real_distribution<double>(lower, upper)(random);
}

inline Eigen::Vector3d random_point(std::mt19937& random, double half_width) {
  const auto one = [&] { return uniform(random, -half_width, half_width); };
  const double x = one(), y = one(), z = one();
  return {x, y, z};
}

inline Eigen::Vector3d random_unit(std::mt19937& random) {
  std::normal_distribution<double> normal;
  const double x = normal(random), y = normal(random), z = normal(random);
  return Eigen::Vector3d(x, y, z).normalized();
}

inline Pose random_pose(std::mt19937& random, double half_width) {
  Pose pose = Pose::Identity();
  pose.linear() =
      Eigen::AngleAxisd(uniform(random, 0, kPi), random_unit(random)).toRotationMatrix();
  pose.translation() = random_point(random, half_width);
  return pose;
}

/// A tetrahedron or a double pyramid, its triangles outward.
inline ConvexHull random_hull(std::mt19937& random) {
  const auto reach = [&] { return uniform(random, 0.02, 0.3); };
  const double a = reach(), b = reach(), c = reach();
  if (random() % 2 == 0) {
    return {{{a, 0, 0}, {0, b, 0}, {0, 0, c}, {0, 0, 0}},
            {{0, 1, 2}, {0, 2, 3}, {1, 3, 2}, {0, 3, 1}}};
  }
  return {{{a, 0, 0}, {-a, 0, 0}, {0, b, 0}, {0, -b, 0}, {0, 0, c}, {0, 0, -c}},
          {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
}

inline Geometry random_geometry(std::mt19937& random, int kind) {
  const auto size = [&] { return uniform(random, 0.02, 0.5); };
  const double a = size(), b = size(), c = size();
  switch (kind) {
    case 0:
      return Box{{a, b, c}};
    case 1:
      return Sphere{a / 2};
    case 2:
      return Cylinder{a / 2, b};
    default:
      return random_hull(random);
  }
}

/// Whether a point of the geometry's frame is in it, to within `slack`; not by support functions.
inline bool contains(const Geometry& geometry, const Eigen::Vector3d& p, double slack) {
  if (const auto* box = std::get_if<Box>(&geometry)) {
    return (p.cwiseAbs().array() <= box->size.array() / 2 + slack).all();
  }
  if (const auto* sphere = std::get_if<Sphere>(&geometry)) {
    return p.norm() <= sphere->radius + slack;
  }
  if (const auto* cylinder = std::get_if<Cylinder>(&geometry)) {
    return std::hypot(p.x(), p.y()) <= cylinder->radius + slack &&
           std::abs(p.z()) <= cylinder->length / 2 + slack;
  }
  const auto& hull = std::get<ConvexHull>(geometry);
  for (const auto& [i, j, k] : hull.triangles) {
    const Eigen::Vector3d& a = hull.vertices[static_cast<std::size_t>(i)];
    const Eigen::Vector3d& b = hull.vertices[static_cast<std::size_t>(j)];
    const Eigen::Vector3d& c = hull.vertices[static_cast<std::size_t>(k)];
    const Eigen::Vector3d outward = (b - a).cross(c - a).normalized();
    if (outward.dot(p - a) > slack) return false;
  }
  return true;
}

/// max over the placed geometry of direction.x, written out without support_point.
inline double reach(const Geometry& geometry, const Pose& pose, const Eigen::Vector3d& direction) {
  const Eigen::Vector3d d = pose.linear().transpose() * direction;
  const double at_origin = direction.dot(pose.translation());
  if (const auto* box = std::get_if<Box>(&geometry)) {
    return at_origin + d.cwiseAbs().dot(box->size) / 2;
  }
  if (const auto* sphere = std::get_if<Sphere>(&geometry)) {
    return at_origin + sphere->radius * d.norm();
  }
  if (const auto* cylinder = std::get_if<Cylinder>(&geometry)) {
    return at_origin + cylinder->radius * std::hypot(d.x(), d.y()) +
           cylinder->length / 2 * std::abs(d.z());
  }
  double most = -1e300;
  for (const auto& v : std::get<ConvexHull>(geometry).vertices) most = std::max(most, d.dot(v));
  return at_origin + most;
}

struct ShapePair {
  Geometry a, b;
  Pose pose_a = Pose::Identity(), pose_b = Pose::Identity();

  SignedDistance measure() const { return signed_distance({a, pose_a}, {b, pose_b}); }
  /// Distance of the planes of this normal that touch the shapes: never above the signed distance.
  double gap(const Eigen::Vector3d& normal) const {
    return -reach(b, pose_b, -normal) - reach(a, pose_a, normal);
  }
};

inline ShapePair random_pair(std::mt19937& random, int kind_a, int kind_b, double half_width) {
  ShapePair pair{random_geometry(random, kind_a), random_geometry(random, kind_b)};
  pair.pose_a = random_pose(random, half_width);
  pair.pose_b = random_pose(random, half_width);
  return pair;
}

}  // namespace wristwise::test
