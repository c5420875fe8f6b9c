#pragma once

#include <vector>

#include "collision/hull_planes.hpp"

namespace wristwise {

/// A convex polyhedron that starts as a box and is cut by planes.
class ConvexCell {
 public:
  explicit ConvexCell(const Eigen::AlignedBox3d& box);

  /// The part below a plane (or above, of the plane turned round).
  /// @param slack m, points so near the plane count as on it
  ConvexCell below(const Plane& plane, double slack) const;

  std::vector<Eigen::Vector3d> vertices() const;  ///< a place may come more than once
  const std::vector<Plane>& planes() const { return planes_; }
  Eigen::Vector3d center() const;

 private:
  using Polygon = std::vector<Eigen::Vector3d>;

  ConvexCell() = default;

  std::vector<Polygon> faces_;
  std::vector<Plane> planes_;
};

/// What of a convex polygon lies below the plane.
std::vector<Eigen::Vector3d> polygon_below(const std::vector<Eigen::Vector3d>& polygon,
                                           const Plane& plane, double slack);

}  // namespace wristwise
