#pragma once

#include <array>
#include <variant>
#include <vector>

#include "wristwise/pose.hpp"
#include "wristwise/visibility.hpp"

namespace WRISTWISE_PUBLIC wristwise {

struct Box {
  Eigen::Vector3d size;  ///< full edge lengths, m; centred
};
struct Sphere {
  double radius;  ///< m
};
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
  Geometry geometry;
  Pose pose = Pose::Identity();
};

/// The point of the geometry that lies farthest along `direction`, in the geometry's own frame.
Eigen::Vector3d support_point(const Geometry& geometry, const Eigen::Vector3d& direction);

/// Radius (m) of the least sphere about the geometry's own origin that holds it.
double bounding_radius(const Geometry& geometry);

}  // namespace wristwise
