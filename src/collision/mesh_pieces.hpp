#pragma once

#include <array>
#include <vector>

#include "wristwise/pose.hpp"

namespace wristwise {

/// Triangles that refer to shared vertices.
struct TriangleSoup {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::array<int, 3>> triangles;
};

/// The points of each connected component; vertices at the same place count as one. In the order
/// of the first triangle of each.
std::vector<std::vector<Eigen::Vector3d>> connected_pieces(const TriangleSoup& soup);

}  // namespace wristwise
