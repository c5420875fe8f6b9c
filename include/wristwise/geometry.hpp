#pragma once

#include <array>
#include <variant>
#include <vector>

#include "wristwise/pose.hpp"
#include "wristwise/visibility.hpp"

namespace WRISTWISE_PUBLIC wristwise {

/// A cuboid about the origin of its frame.
struct Box {
  Eigen::Vector3d size;  ///< full edge lengths, m; centred
};
/// A ball about the origin of its frame.
struct Sphere {
  double radius;  ///< m
};
/// A round, solid cylinder with flat ends.
struct Cylinder {
  double radius;  ///< m
  double length;  ///< m, along z, centred
};
/// A convex polyhedron. Concave meshes become several of these.
struct ConvexHull {
  std::vector<Eigen::Vector3d> vertices;      ///< m
  std::vector<std::array<int, 3>> triangles;  ///< outward, counter-clockwise
};

/// Every geometry is convex: distance and penetration depth are then well defined.
using Geometry = std::variant<Box, Sphere, Cylinder, ConvexHull>;

/// A geometry placed in the frame of the body that carries it.
struct Shape {
  Geometry geometry;             ///< in its own frame
  Pose pose = Pose::Identity();  ///< of that frame, in the body's; m
};

/// The point (m) of the geometry that lies farthest along `direction` (of any length but zero),
/// both in the geometry's own frame.
Eigen::Vector3d support_point(const Geometry& geometry, const Eigen::Vector3d& direction);

/// Radius (m) of the least sphere about the geometry's own origin that holds it.
double bounding_radius(const Geometry& geometry);

}  // namespace wristwise
