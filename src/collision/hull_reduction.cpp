#include "collision/hull_reduction.hpp"

#include <algorithm>
#include <optional>

#include "collision/hull_planes.hpp"
#include "collision/triangle_tree.hpp"
#include "wristwise/error.hpp"
#include "wristwise/mesh.hpp"

namespace wristwise {

namespace {

constexpr std::size_t kMostRounds = 60;
constexpr double kWorthwhile = 0.7;  // of the vertices
constexpr double kRounding = 1e-9;   // of the size

/// The smallest known polyhedron of half-spaces that hold a hull, made tighter where it is too
/// wide.
class OuterHull {
 public:
  explicit OuterHull(const ConvexHull& hull)
      : hull_(hull), mesh_{hull.vertices, hull.triangles}, tree_(mesh_) {
    middle_ = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& vertex : hull.vertices) {
      middle_ += vertex / static_cast<double>(hull.vertices.size());
    }
    for (int axis = 0; axis < 3; ++axis) {
      add(Eigen::Vector3d::Unit(axis));
      add(-Eigen::Vector3d::Unit(axis));
    }
  }

  /// Cuts off the corners that are too far out, the farthest first; false where there was none.
  bool tighten(double error) {
    const std::size_t known = planes_.size();
    for (const auto& [corner, nearest] : far_corners(error)) {
      const bool cut_off = std::any_of(
          planes_.begin() + static_cast<long>(known), planes_.end(),
          [&, at = corner](const Plane& plane) { return plane.height(at) > error / 2; });
      if (!cut_off) add((corner - nearest.point) / nearest.distance);
    }
    return planes_.size() > known;
  }

  std::size_t size() const { return planes_.size(); }
  ConvexHull result() const { return convex_hull(corners(), "outer hull"); }

 private:
  using FarCorner = std::pair<Eigen::Vector3d, NearestOnMesh>;

  std::vector<FarCorner> far_corners(double error) const {
    std::vector<FarCorner> far;
    for (const Eigen::Vector3d& corner : corners()) {
      const NearestOnMesh nearest = tree_.nearest(corner);
      if (nearest.distance > error) far.emplace_back(corner, nearest);
    }
    std::stable_sort(far.begin(), far.end(), [](const FarCorner& a, const FarCorner& b) {
      return a.second.distance > b.second.distance;
    });
    return far;
  }

  void add(const Eigen::Vector3d& normal) {
    double offset = normal.dot(hull_.vertices.front());
    for (const Eigen::Vector3d& vertex : hull_.vertices) {
      offset = std::max(offset, normal.dot(vertex));
    }
    planes_.push_back({normal, offset});
  }

  // Planes n.x = o about a point inside are points n / o, and the faces of their hull are the
  // corners of the half-spaces' common part (duality).
  std::vector<Eigen::Vector3d> corners() const {
    std::vector<Eigen::Vector3d> duals;
    duals.reserve(planes_.size());
    for (const Plane& plane : planes_) duals.emplace_back(plane.normal / -plane.height(middle_));
    const ConvexHull dual = convex_hull(duals, "outer hull");
    std::vector<Eigen::Vector3d> points;
    for (const Plane& face : hull_planes(dual)) {
      points.emplace_back(middle_ + face.normal / face.offset);
    }
    return points;
  }

  const ConvexHull& hull_;
  TriangleMesh mesh_;
  TriangleTree tree_;
  Eigen::Vector3d middle_;
  std::vector<Plane> planes_;
};

bool contains(const ConvexHull& outer, const ConvexHull& inner, double slack) {
  const std::vector<Plane> planes = hull_planes(outer);
  return std::all_of(inner.vertices.begin(), inner.vertices.end(), [&](const Eigen::Vector3d& v) {
    return std::all_of(planes.begin(), planes.end(),
                       [&](const Plane& plane) { return plane.height(v) <= slack; });
  });
}

std::optional<ConvexHull> smaller_hull(const ConvexHull& hull, double error) {
  OuterHull outer(hull);
  bool wide = true;
  for (std::size_t round = 0; round < kMostRounds && wide; ++round) {
    wide = outer.tighten(error);
    if (outer.size() > hull.vertices.size() / 2) return std::nullopt;
  }
  if (wide) return std::nullopt;
  return outer.result();
}

}  // namespace

ConvexHull reduced_hull(const ConvexHull& hull, double error) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& vertex : hull.vertices) box.extend(vertex);
  try {
    const auto smaller = smaller_hull(hull, error);
    const auto most = kWorthwhile * static_cast<double>(hull.vertices.size());
    if (smaller && static_cast<double>(smaller->vertices.size()) < most &&
        contains(*smaller, hull, kRounding * box.sizes().maxCoeff())) {
      return *smaller;
    }
  } catch (const InvalidInput&) {  // rounding left no hull
  }
  return hull;
}

}  // namespace wristwise
