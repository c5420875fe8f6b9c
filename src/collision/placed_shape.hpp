#pragma once

#include "wristwise/geometry.hpp"

namespace wristwise {

/// A sphere that holds a geometry, in the geometry's own frame.
struct BoundingBall {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  double radius = 0;
};

/// A ball about the middle of the geometry; unlike bounding_radius, tight for a hull that lies far
/// from its own origin.
BoundingBall bounding_ball(const Geometry& geometry);

/// A geometry at a pose in the base frame. Refers to what the caller keeps alive.
struct PlacedShape {
  const Geometry& geometry;
  const Pose& pose;
};

/// The core of a geometry: a sphere's centre, everything else as it is.
inline Eigen::Vector3d core_support(const PlacedShape& shape, const Eigen::Vector3d& direction) {
  if (std::holds_alternative<Sphere>(shape.geometry)) return shape.pose.translation();
  return shape.pose * support_point(shape.geometry, shape.pose.linear().transpose() * direction);
}

/// What the geometry adds to its core on all sides, m.
inline double core_margin(const PlacedShape& shape) {
  const auto* sphere = std::get_if<Sphere>(&shape.geometry);
  return sphere ? sphere->radius : 0.0;
}

/// Points of two cores and their difference b - a: a point of the Minkowski difference.
struct DifferencePoint {
  Eigen::Vector3d on_a, on_b, difference;
};

/// The point of core b - core a that lies farthest along `direction`.
inline DifferencePoint difference_support(const PlacedShape& a, const PlacedShape& b,
                                          const Eigen::Vector3d& direction) {
  DifferencePoint point;
  point.on_a = core_support(a, -direction);
  point.on_b = core_support(b, direction);
  point.difference = point.on_b - point.on_a;
  return point;
}

}  // namespace wristwise
