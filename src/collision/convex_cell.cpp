#include "collision/convex_cell.hpp"

#include <algorithm>
#include <cmath>

namespace wristwise {

namespace {

/// Sorted round their middle, in the plane.
void sort_round(std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& normal) {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& point : points) middle += point / static_cast<double>(points.size());
  const Eigen::Vector3d u = normal.unitOrthogonal(), v = normal.cross(u);
  std::vector<std::pair<double, Eigen::Vector3d>> turned;
  turned.reserve(points.size());
  for (const Eigen::Vector3d& point : points) {
    turned.emplace_back(std::atan2(v.dot(point - middle), u.dot(point - middle)), point);
  }
  std::stable_sort(turned.begin(), turned.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  for (std::size_t i = 0; i < points.size(); ++i) points[i] = turned[i].second;
}

}  // namespace

std::vector<Eigen::Vector3d> polygon_below(const std::vector<Eigen::Vector3d>& polygon,
                                           const Plane& plane, double slack) {
  std::vector<Eigen::Vector3d> below;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector3d &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const double hp = plane.height(p), hq = plane.height(q);
    if (hp <= slack) below.push_back(p);
    const bool crosses = (hp > slack && hq < -slack) || (hp < -slack && hq > slack);
    if (crosses) below.emplace_back(p + hp / (hp - hq) * (q - p));
  }
  return below;
}

ConvexCell::ConvexCell(const Eigen::AlignedBox3d& box) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const int side : {-1, 1}) {
      const Eigen::Vector3d normal = side * Eigen::Vector3d::Unit(axis);
      planes_.push_back({normal, side < 0 ? -box.min()[axis] : box.max()[axis]});
      Polygon face;
      for (int corner = 0; corner < 8; ++corner) {
        const bool upper = (corner & (1 << axis)) != 0;
        if (upper == (side > 0)) {
          face.push_back(box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner)));
        }
      }
      sort_round(face, normal);
      faces_.push_back(std::move(face));
    }
  }
}

ConvexCell ConvexCell::below(const Plane& plane, double slack) const {
  ConvexCell cell;
  cell.planes_ = planes_;
  cell.planes_.push_back(plane);
  Polygon lid;
  for (const Polygon& face : faces_) {
    Polygon kept = polygon_below(face, plane, slack);
    for (const Eigen::Vector3d& point : kept) {
      if (std::abs(plane.height(point)) <= slack) lid.push_back(point);
    }
    if (kept.size() >= 3) cell.faces_.push_back(std::move(kept));
  }
  if (lid.size() >= 3) {
    sort_round(lid, plane.normal);
    cell.faces_.push_back(std::move(lid));
  }
  return cell;
}

std::vector<Eigen::Vector3d> ConvexCell::vertices() const {
  std::vector<Eigen::Vector3d> all;
  for (const Polygon& face : faces_) all.insert(all.end(), face.begin(), face.end());
  return all;
}

Eigen::Vector3d ConvexCell::center() const {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  const std::vector<Eigen::Vector3d> all = vertices();
  for (const Eigen::Vector3d& vertex : all) sum += vertex;
  return sum / static_cast<double>(std::max<std::size_t>(all.size(), 1));
}

}  // namespace wristwise
