#pragma once

#include <array>
#include <map>
#include <optional>
#include <vector>

#include "collision/convex_cell.hpp"
#include "collision/part.hpp"

namespace wristwise {

/// What a part has in a convex cell, and the hull of that.
struct CutPiece {
  struct Patch {
    std::vector<Eigen::Vector3d> corners;  ///< of a convex polygon
    std::size_t triangle = 0;              ///< of the part, in which it lies
  };

  ConvexCell cell;
  std::vector<Patch> surface;
  ConvexHull hull;
};

/// Cuts a part by planes. Whatever the planes, the hulls of the pieces together contain the part
/// (F40).
class PartCutter {
 public:
  explicit PartCutter(const Part& part);

  const Part& part() const { return part_; }
  double slack() const { return slack_; }  ///< m, points so near a plane count as on it

  CutPiece whole() const;

  /// The pieces on both sides; nullopt where the plane leaves nothing on one of them.
  std::optional<std::array<CutPiece, 2>> cut(const CutPiece& piece, const Plane& plane) const;

  /// Whether the piece of a solid is its own hull.
  bool is_convex(const CutPiece& piece) const;

 private:
  std::optional<CutPiece> below(const CutPiece& piece, const Plane& plane) const;
  bool find_hull(CutPiece& piece) const;
  void add_inner_corners(const CutPiece& piece, std::vector<Eigen::Vector3d>& points) const;
  bool is_inside(const Eigen::Vector3d& corner, const Eigen::Vector3d& center) const;
  double winding(const Eigen::Vector3d& point) const;

  const Part& part_;
  double slack_;
  mutable std::map<std::array<double, 3>, double> windings_;
};

/// The hull of points, or where they have no volume of those points made thicker by `thickness` (m)
/// all round.
ConvexHull thick_hull(const std::vector<Eigen::Vector3d>& points, double thickness);

}  // namespace wristwise
