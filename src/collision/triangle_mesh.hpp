#pragma once

#include <array>
#include <vector>

#include "wristwise/pose.hpp"

namespace wristwise {

/// Triangles that refer to shared vertices.
struct TriangleMesh {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::array<int, 3>> triangles;

  const Eigen::Vector3d& corner(std::size_t triangle, std::size_t i) const {
    return vertices[static_cast<std::size_t>(triangles[triangle][i])];
  }
  Eigen::AlignedBox3d box() const {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& vertex : vertices) box.extend(vertex);
    return box;
  }
};

/// The connected parts, in the order of the first triangle of each. Vertices at the same place
/// become one; triangles without an area in vertices, and repeated ones, are dropped.
std::vector<TriangleMesh> connected_parts(const TriangleMesh& mesh);

/// The mesh with vertices united that are no farther apart than `distance` (m).
TriangleMesh welded(const TriangleMesh& mesh, double distance);

/// Whether each edge joins just two triangles, and the surface has two sides; its triangles are
/// then turned outward.
bool close_outward(TriangleMesh& mesh);

}  // namespace wristwise
