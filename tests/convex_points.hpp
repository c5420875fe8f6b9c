#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

// Distances of points from convex bodies in closed form, and of segments by a search: the distance
// from a convex body is a convex function along a line.
namespace wristwise::test {

/// Distance (m) of a point from a body; 0 inside.
using ConvexBody = std::function<double(const Eigen::Vector3d&)>;

/// @param size full edge lengths along x, y, z
inline ConvexBody box_body(const Eigen::Vector3d& center, const Eigen::Vector3d& size) {
  return [=](const Eigen::Vector3d& p) {
    return ((p - center).cwiseAbs() - size / 2).cwiseMax(0).norm();
  };
}

/// With its axis along z.
inline ConvexBody upright_cylinder(const Eigen::Vector3d& center, double radius, double length) {
  return [=](const Eigen::Vector3d& p) {
    const double beside = std::max(0.0, (p - center).head<2>().norm() - radius);
    const double above = std::max(0.0, std::abs(p.z() - center.z()) - length / 2);
    return std::hypot(beside, above);
  };
}

/// A right-angled triangle with legs `along_x` and `along_z` from the corner, times `width` along y
/// about it.
inline ConvexBody prism_body(const Eigen::Vector3d& corner, double along_x, double along_z,
                             double width) {
  return [=](const Eigen::Vector3d& p) {
    const Eigen::Vector2d at(p.x() - corner.x(), p.z() - corner.z());
    const std::array<Eigen::Vector2d, 3> corners = {
        Eigen::Vector2d(0, 0), {along_x, 0}, {0, along_z}};
    const bool inside = at.x() >= 0 && at.y() >= 0 && at.x() / along_x + at.y() / along_z <= 1;
    double in_plane = inside ? 0 : 1e9;
    for (std::size_t k = 0; k < 3 && !inside; ++k) {
      const Eigen::Vector2d& from = corners[k];
      const Eigen::Vector2d edge = corners[(k + 1) % 3] - from;
      const double share = std::clamp((at - from).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
      in_plane = std::min(in_plane, (at - from - share * edge).norm());
    }
    return std::hypot(in_plane, std::max(0.0, std::abs(p.y() - corner.y()) - width / 2));
  };
}

inline double distance_to_segment(const ConvexBody& body, const Eigen::Vector3d& a,
                                  const Eigen::Vector3d& b) {
  const auto at = [&](double s) { return body(a + s * (b - a)); };
  double low = 0, high = 1;
  for (int k = 0; k < 100; ++k) {
    const double left = low + (high - low) / 3, right = high - (high - low) / 3;
    if (at(left) < at(right)) {
      high = right;
    } else {
      low = left;
    }
  }
  return at((low + high) / 2);
}

}  // namespace wristwise::test
