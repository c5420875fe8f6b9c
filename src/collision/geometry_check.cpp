#include "collision/geometry_check.hpp"

#include <cmath>

#include "wristwise/error.hpp"

namespace wristwise {

namespace {

void check_size(const std::string& where, const char* name, double size) {
  if (std::isfinite(size) && size > 0) return;
  throw InvalidInput(where, std::string(name) + " is " + std::to_string(size),
                     "a finite length above zero");
}

void check_geometry(const std::string& where, const Box& box) {
  for (const double edge : {box.size.x(), box.size.y(), box.size.z()}) {
    check_size(where, "edge of a box", edge);
  }
}

void check_geometry(const std::string& where, const Sphere& sphere) {
  check_size(where, "radius of a sphere", sphere.radius);
}

void check_geometry(const std::string& where, const Cylinder& cylinder) {
  check_size(where, "radius of a cylinder", cylinder.radius);
  check_size(where, "length of a cylinder", cylinder.length);
}

void check_geometry(const std::string& where, const ConvexHull& hull) {
  if (hull.vertices.size() < 4) {
    throw InvalidInput(where, "hull of " + std::to_string(hull.vertices.size()) + " vertices",
                       "at least 4");
  }
  for (const Eigen::Vector3d& vertex : hull.vertices) {
    if (!vertex.allFinite()) throw InvalidInput(where, "vertex that is not finite", "numbers");
  }
}

}  // namespace

void check_shape(const std::string& where, const Shape& shape) {
  std::visit([&](const auto& geometry) { check_geometry(where, geometry); }, shape.geometry);
  if (!shape.pose.matrix().allFinite()) {
    throw InvalidInput(where, "pose of a shape is not finite", "numbers");
  }
}

}  // namespace wristwise
