#pragma once

#include <array>

#include "collision/placed_shape.hpp"

namespace wristwise {

/// A convex polytope inside the Minkowski difference of two cores, grown point by point. It need
/// not hold the origin: the offset of a face is signed.
class Polytope {
 public:
  static constexpr int kMaxVertices = 160;

  struct Face {
    std::array<int, 3> vertex{};
    Eigen::Vector3d normal;  ///< unit, outward
    double offset = 0;       ///< of the face's plane from the origin, along the normal
  };

  /// A tetrahedron of points of the difference that are far apart.
  Polytope(const PlacedShape& a, const PlacedShape& b);

  /// The face whose plane is the least distance along its normal from the origin.
  const Face& nearest_face() const;

  /// The hull of the polytope and a point outside it. False where there is no room left or rounding
  /// spoils the shape; the polytope is then of no more use.
  bool add(const DifferencePoint& point);

  /// The points of the shapes that make the point of the face nearest to the origin.
  void points_of(const Face& face, Eigen::Vector3d& on_a, Eigen::Vector3d& on_b) const;

 private:
  static constexpr int kMaxFaces = 2 * kMaxVertices;

  bool add_face(int i, int j, int k);
  /// Barycentric coordinates of a point of the face's plane.
  Eigen::Array3d weights(const Face& face, const Eigen::Vector3d& point) const;
  const Eigen::Vector3d& at(int vertex) const {
    return vertices_[static_cast<std::size_t>(vertex)].difference;
  }

  std::array<DifferencePoint, kMaxVertices> vertices_;
  std::array<Face, kMaxFaces> faces_;
  int vertex_count_ = 0;
  int face_count_ = 0;
  Eigen::Vector3d inside_;  ///< a point inside, to orient faces by
};

}  // namespace wristwise
