#include "collision/point_distance.hpp"

#include <cmath>

namespace wristwise {

namespace {

// Nearer than this to the surface, the direction to the nearest point is lost to rounding.
constexpr double kOnSurface = 1e-12;

}  // namespace

PointDistance point_distance(const Box& box, const Eigen::Vector3d& point) {
  const Eigen::Vector3d excess = point.cwiseAbs() - box.size / 2;
  const Eigen::Vector3d outside = excess.cwiseMax(0);
  const double distance = outside.norm();
  if (distance > kOnSurface) {
    const Eigen::Vector3d sign = point.unaryExpr([](double x) { return std::copysign(1.0, x); });
    return {distance, outside.cwiseProduct(sign) / distance};
  }
  Eigen::Index face = 0;
  const double depth = excess.maxCoeff(&face);
  return {depth, std::copysign(1.0, point[face]) * Eigen::Vector3d::Unit(face)};
}

PointDistance point_distance(const Cylinder& cylinder, const Eigen::Vector3d& point) {
  const double across = std::sqrt(point.x() * point.x() + point.y() * point.y());
  const double radial = across - cylinder.radius;
  const double axial = std::abs(point.z()) - cylinder.length / 2;
  const Eigen::Vector3d radial_direction =
      across > 0 ? Eigen::Vector3d(point.x() / across, point.y() / across, 0)
                 : Eigen::Vector3d::UnitX();
  const Eigen::Vector3d axial_direction(0, 0, std::copysign(1.0, point.z()));
  const double out_radial = std::max(radial, 0.0);
  const double out_axial = std::max(axial, 0.0);
  const double distance = std::sqrt(out_radial * out_radial + out_axial * out_axial);
  if (distance > kOnSurface) {
    return {distance, (out_radial * radial_direction + out_axial * axial_direction) / distance};
  }
  if (radial > axial) return {radial, radial_direction};
  return {axial, axial_direction};
}

}  // namespace wristwise
