#include <cmath>

#include "collision/placed_shape.hpp"

namespace wristwise {

namespace {

template <class... F>
struct Overloaded : F... {
  using F::operator()...;
};
template <class... F>
Overloaded(F...) -> Overloaded<F...>;

Eigen::Vector3d support_of(const Box& box, const Eigen::Vector3d& d) {
  return {std::copysign(box.size.x() / 2, d.x()), std::copysign(box.size.y() / 2, d.y()),
          std::copysign(box.size.z() / 2, d.z())};
}

Eigen::Vector3d support_of(const Sphere& sphere, const Eigen::Vector3d& d) {
  const double norm = d.stableNorm();
  if (!(norm > 0)) return {sphere.radius, 0, 0};
  return sphere.radius / norm * d;
}

Eigen::Vector3d support_of(const Cylinder& cylinder, const Eigen::Vector3d& d) {
  const double z = std::copysign(cylinder.length / 2, d.z());
  const double across = std::sqrt(d.x() * d.x() + d.y() * d.y());
  if (!(across > 0)) return {cylinder.radius, 0, z};
  const double scale = cylinder.radius / across;
  return {scale * d.x(), scale * d.y(), z};
}

Eigen::Vector3d support_of(const ConvexHull& hull, const Eigen::Vector3d& d) {
  const Eigen::Vector3d* best = &hull.vertices.front();
  double farthest = best->dot(d);
  for (const Eigen::Vector3d& vertex : hull.vertices) {
    const double along = vertex.dot(d);
    if (along > farthest) {
      farthest = along;
      best = &vertex;
    }
  }
  return *best;
}

double radius_about(const std::vector<Eigen::Vector3d>& vertices, const Eigen::Vector3d& center) {
  double squared = 0;
  for (const Eigen::Vector3d& vertex : vertices) {
    squared = std::max(squared, (vertex - center).squaredNorm());
  }
  return std::sqrt(squared);
}

}  // namespace

Eigen::Vector3d support_point(const Geometry& geometry, const Eigen::Vector3d& direction) {
  return std::visit([&](const auto& shape) { return support_of(shape, direction); }, geometry);
}

double bounding_radius(const Geometry& geometry) {
  return std::visit(
      Overloaded{
          [](const Box& box) { return box.size.norm() / 2; },
          [](const Sphere& sphere) { return sphere.radius; },
          [](const Cylinder& c) { return std::hypot(c.radius, c.length / 2); },
          [](const ConvexHull& h) { return radius_about(h.vertices, Eigen::Vector3d::Zero()); },
      },
      geometry);
}

BoundingBall bounding_ball(const Geometry& geometry) {
  const auto* hull = std::get_if<ConvexHull>(&geometry);
  if (!hull) return {Eigen::Vector3d::Zero(), bounding_radius(geometry)};
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& vertex : hull->vertices) box.extend(vertex);
  return {box.center(), radius_about(hull->vertices, box.center())};
}

}  // namespace wristwise
