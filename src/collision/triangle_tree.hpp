#pragma once

#include <vector>

#include "collision/triangle_mesh.hpp"

namespace wristwise {

/// The point of a mesh that is nearest to another point.
struct NearestOnMesh {
  double distance = 0;    ///< m
  Eigen::Vector3d point;  ///< on the mesh
  std::size_t triangle = 0;
  /// Of the triangle's corners; zeros tell a corner or an edge from the inside.
  Eigen::Vector3d weights;
};

/// The nearest point of a triangle, as weights of its corners (Ericson 2005, 5.1.5).
Eigen::Vector3d nearest_weights(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                const Eigen::Vector3d& c, const Eigen::Vector3d& p);

/// Boxes in boxes round the triangles of a mesh. Refers to a mesh that the caller keeps alive.
class TriangleTree {
 public:
  explicit TriangleTree(const TriangleMesh& mesh);

  NearestOnMesh nearest(const Eigen::Vector3d& point) const;

 private:
  struct Node {
    Eigen::AlignedBox3d box;
    int first = 0, count = 0;  ///< of a leaf's triangles in order_
    int left = -1, right = -1;
  };

  int build(int first, int count, const std::vector<Eigen::Vector3d>& centers);

  const TriangleMesh& mesh_;
  std::vector<int> order_;
  std::vector<Node> nodes_;
};

}  // namespace wristwise
