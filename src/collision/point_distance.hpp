#pragma once

#include "wristwise/geometry.hpp"

namespace wristwise {

/// Signed distance of a point from a solid, and the unit normal along which it grows: the nearest
/// point of the surface is point - distance * normal, inside as well as outside.
struct PointDistance {
  double distance;
  Eigen::Vector3d normal;
};

/// `point` in the solid's own frame.
PointDistance point_distance(const Box& box, const Eigen::Vector3d& point);
PointDistance point_distance(const Cylinder& cylinder, const Eigen::Vector3d& point);

}  // namespace wristwise
