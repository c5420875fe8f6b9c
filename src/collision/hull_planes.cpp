#include "collision/hull_planes.hpp"

#include <algorithm>
#include <cmath>

namespace wristwise {

namespace {

double plane_offset(const ConvexHull& hull, const Eigen::Vector3d& normal) {
  double offset = normal.dot(hull.vertices.front());
  for (const Eigen::Vector3d& vertex : hull.vertices) {
    offset = std::max(offset, normal.dot(vertex));
  }
  return offset;
}

}  // namespace

std::vector<Plane> hull_planes(const ConvexHull& hull) {
  std::vector<Plane> planes;
  for (const auto& [i, j, k] : hull.triangles) {
    const Eigen::Vector3d& a = hull.vertices[static_cast<std::size_t>(i)];
    const Eigen::Vector3d across = (hull.vertices[static_cast<std::size_t>(j)] - a)
                                       .cross(hull.vertices[static_cast<std::size_t>(k)] - a);
    const double area = across.norm();
    if (!(area > 0)) continue;
    // The normal of a sliver is rough; with the farthest vertex the half-space holds the hull.
    Plane plane{across / area, plane_offset(hull, across / area)};
    // Qhull cuts a face of many corners into triangles that follow one another.
    const bool known = !planes.empty() && planes.back().normal.dot(plane.normal) > 1 - 1e-14 &&
                       std::abs(planes.back().offset - plane.offset) < 1e-12;
    if (!known) planes.push_back(plane);
  }
  return planes;
}

double hull_volume(const ConvexHull& hull) {
  double sixfold = 0;
  for (const auto& [i, j, k] : hull.triangles) {
    const Eigen::Vector3d& origin = hull.vertices.front();
    const Eigen::Vector3d a = hull.vertices[static_cast<std::size_t>(i)] - origin;
    const Eigen::Vector3d b = hull.vertices[static_cast<std::size_t>(j)] - origin;
    const Eigen::Vector3d c = hull.vertices[static_cast<std::size_t>(k)] - origin;
    sixfold += a.dot(b.cross(c));
  }
  return sixfold / 6;
}

}  // namespace wristwise
