#include "collision/cut_piece.hpp"

#include <algorithm>
#include <cmath>

#include "wristwise/error.hpp"
#include "wristwise/mesh.hpp"

namespace wristwise {

namespace {

// Coordinates of STL files have 24 bits.
constexpr double kSlack = 1e-6;      // of the extent
constexpr double kThickness = 1e-5;  // of the extent, of a sheet

double slack_of(const Part& part) {
  double farthest = 0;
  for (const Eigen::Vector3d& vertex : part.mesh().vertices) {
    farthest = std::max(farthest, vertex.cwiseAbs().maxCoeff());
  }
  return kSlack * std::max(part.extent(), farthest);
}

/// Triangles share their corners.
void drop_repeated(std::vector<Eigen::Vector3d>& points) {
  std::sort(points.begin(), points.end(), [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
  });
  points.erase(std::unique(points.begin(), points.end()), points.end());
}

std::optional<ConvexHull> hull_with_volume(const std::vector<Eigen::Vector3d>& points) {
  try {
    return convex_hull(points, "piece");
  } catch (const InvalidInput&) {
    return std::nullopt;
  }
}

}  // namespace

ConvexHull thick_hull(const std::vector<Eigen::Vector3d>& points, double thickness) {
  if (auto hull = hull_with_volume(points)) return *hull;
  std::vector<Eigen::Vector3d> thicker;
  for (const Eigen::Vector3d& point : points) {
    for (int axis = 0; axis < 3; ++axis) {
      thicker.emplace_back(point + thickness * Eigen::Vector3d::Unit(axis));
      thicker.emplace_back(point - thickness * Eigen::Vector3d::Unit(axis));
    }
  }
  return convex_hull(thicker, "piece");
}

PartCutter::PartCutter(const Part& part) : part_(part), slack_(slack_of(part)) {}

CutPiece PartCutter::whole() const {
  Eigen::AlignedBox3d box = part_.box();
  const Eigen::Vector3d margin = Eigen::Vector3d::Constant(0.1 * part_.extent());
  CutPiece piece{ConvexCell({box.min() - margin, box.max() + margin}), {}, {}};
  for (std::size_t t = 0; t < part_.mesh().triangles.size(); ++t) {
    piece.surface.push_back(
        {{part_.mesh().corner(t, 0), part_.mesh().corner(t, 1), part_.mesh().corner(t, 2)}, t});
  }
  piece.hull = thick_hull(part_.mesh().vertices, kThickness * part_.extent());
  return piece;
}

std::optional<std::array<CutPiece, 2>> PartCutter::cut(const CutPiece& piece,
                                                       const Plane& plane) const {
  auto lower = below(piece, plane);
  if (!lower) return std::nullopt;
  auto upper = below(piece, {-plane.normal, -plane.offset});
  if (!upper) return std::nullopt;
  return std::array<CutPiece, 2>{std::move(*lower), std::move(*upper)};
}

std::optional<CutPiece> PartCutter::below(const CutPiece& piece, const Plane& plane) const {
  CutPiece child{piece.cell.below(plane, slack_), {}, {}};
  for (const CutPiece::Patch& patch : piece.surface) {
    double lowest = 0, highest = 0;
    for (const Eigen::Vector3d& corner : patch.corners) {
      lowest = std::min(lowest, plane.height(corner));
      highest = std::max(highest, plane.height(corner));
    }
    if (highest <= slack_ && lowest >= -slack_) {
      // It lies in the plane, and belongs to the side on which it has the part behind it.
      if (part_.normal(patch.triangle).dot(plane.normal) > 0) child.surface.push_back(patch);
    } else if (lowest < -slack_) {
      child.surface.push_back({polygon_below(patch.corners, plane, slack_), patch.triangle});
    }
  }
  if (child.surface.empty() || !find_hull(child)) return std::nullopt;
  return child;
}

bool PartCutter::find_hull(CutPiece& piece) const {
  std::vector<Eigen::Vector3d> points;
  for (const CutPiece::Patch& patch : piece.surface) {
    points.insert(points.end(), patch.corners.begin(), patch.corners.end());
  }
  drop_repeated(points);
  if (part_.closed()) {
    add_inner_corners(piece, points);
    auto hull = hull_with_volume(points);
    if (hull) piece.hull = std::move(*hull);
    return hull.has_value();
  }
  piece.hull = thick_hull(points, kThickness * part_.extent());
  return true;
}

void PartCutter::add_inner_corners(const CutPiece& piece,
                                   std::vector<Eigen::Vector3d>& points) const {
  const Eigen::Vector3d center = piece.cell.center();
  for (const Eigen::Vector3d& corner : piece.cell.vertices()) {
    if (is_inside(corner, center)) points.push_back(corner);
  }
}

// A corner of the cell counts where the cell near it is full of the solid. On the surface of the
// solid a point a little inside the cell tells.
bool PartCutter::is_inside(const Eigen::Vector3d& corner, const Eigen::Vector3d& center) const {
  const double near = 20 * slack_;
  if (part_.box().squaredExteriorDistance(corner) > near * near) return false;
  const double distance = part_.distance(corner);
  if (distance < -near) return true;
  if (winding(corner) > 0.99) return true;
  if (distance > near) return false;
  return winding(corner + near * (center - corner).normalized()) > 0.5;
}

double PartCutter::winding(const Eigen::Vector3d& point) const {
  const auto [entry, is_new] = windings_.try_emplace({point.x(), point.y(), point.z()}, 0.0);
  if (is_new) entry->second = std::abs(part_.winding(point));
  return entry->second;
}

// Where the hull is nowhere above the plane of any patch, the surface lies on the hull's.
bool PartCutter::is_convex(const CutPiece& piece) const {
  if (!part_.closed()) return false;
  for (const CutPiece::Patch& patch : piece.surface) {
    const Eigen::Vector3d normal = part_.normal(patch.triangle);
    const double limit = normal.dot(patch.corners.front()) + slack_;
    for (const Eigen::Vector3d& vertex : piece.hull.vertices) {
      if (normal.dot(vertex) > limit) return false;
    }
  }
  return true;
}

}  // namespace wristwise
