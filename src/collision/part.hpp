#pragma once

#include <array>
#include <vector>

#include "collision/triangle_tree.hpp"

namespace wristwise {

/// A connected surface and what it encloses: a solid where it is closed, otherwise itself alone.
class Part {
 public:
  /// @param closed a closed surface with its triangles outward; false: the surface is all there is
  Part(TriangleMesh mesh, bool closed);
  Part(const Part&) = delete;
  Part& operator=(const Part&) = delete;

  const TriangleMesh& mesh() const { return mesh_; }
  bool closed() const { return closed_; }
  const Eigen::AlignedBox3d& box() const { return box_; }
  double extent() const { return box_.sizes().maxCoeff(); }  ///< m
  Eigen::Vector3d normal(std::size_t triangle) const { return face_normals_[triangle]; }

  /// Distance of a point from the part, m; negative: so deep inside a solid. Where a surface
  /// passes through itself, a point inside may be taken for one outside, not the reverse.
  double distance(const Eigen::Vector3d& point) const;

  /// How often the surface winds round the point (Jacobson 2013): 1 inside a solid, 0 outside,
  /// between them on the surface.
  double winding(const Eigen::Vector3d& point) const;

 private:
  void find_normals();
  Eigen::Vector3d normal_at(const NearestOnMesh& nearest) const;

  TriangleMesh mesh_;
  bool closed_;
  Eigen::AlignedBox3d box_;
  TriangleTree tree_;
  std::vector<Eigen::Vector3d> face_normals_, vertex_normals_;
  std::vector<std::array<Eigen::Vector3d, 3>> edge_normals_;  ///< opposite corner 0, 1, 2
};

}  // namespace wristwise
