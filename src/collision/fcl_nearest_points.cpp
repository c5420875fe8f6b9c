#include "collision/fcl_nearest_points.hpp"

#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

#include <cmath>
#include <variant>

#include "collision/point_distance.hpp"

namespace wristwise {

namespace {

constexpr double kFclTolerance = 1e-9;  // of its iterations; looser ones err by up to 5e-2 m

/// Calls `use` with FCL's form of a box or cylinder, made on the stack.
template <class Use>
bool with_fcl_shape(const Geometry& geometry, const Use& use) {
  if (const auto* box = std::get_if<Box>(&geometry)) {
    const fcl::Boxd shape(box->size);
    use(shape);
    return true;
  }
  if (const auto* rod = std::get_if<Cylinder>(&geometry)) {
    const fcl::Cylinderd shape(rod->radius, rod->length);
    use(shape);
    return true;
  }
  return false;
}

/// False where the shapes touch.
bool find_nearest(const fcl::CollisionGeometryd& shape_a, const Pose& pose_a,
                  const fcl::CollisionGeometryd& shape_b, const Pose& pose_b,
                  CertifiedDistance& found) {
  fcl::CollisionResultd touching;
  if (fcl::collide(&shape_a, pose_a, &shape_b, pose_b, fcl::CollisionRequestd(1, false), touching) >
      0) {
    return false;
  }
  fcl::DistanceResultd nearest;
  const fcl::DistanceRequestd request(true, false, 0, 0, kFclTolerance);
  found.upper = fcl::distance(&shape_a, pose_a, &shape_b, pose_b, request, nearest);
  found.on_a = nearest.nearest_points[0];
  found.on_b = nearest.nearest_points[1];
  return found.upper > 0;
}

bool is_on_surface(const PlacedShape& shape, const Eigen::Vector3d& point, double tolerance) {
  const Eigen::Vector3d local = shape.pose.inverse(Eigen::Isometry) * point;
  const auto* box = std::get_if<Box>(&shape.geometry);
  const PointDistance found = box != nullptr
                                  ? point_distance(*box, local)
                                  : point_distance(std::get<Cylinder>(shape.geometry), local);
  return std::abs(found.distance) <= tolerance;
}

}  // namespace

std::optional<CertifiedDistance> fcl_nearest_points(const PlacedShape& a, const PlacedShape& b,
                                                    double tolerance) {
  CertifiedDistance found;
  bool separated = false;
  with_fcl_shape(a.geometry, [&](const auto& shape_a) {
    with_fcl_shape(b.geometry, [&](const auto& shape_b) {
      separated = find_nearest(shape_a, a.pose, shape_b, b.pose, found);
    });
  });
  if (!separated) return std::nullopt;
  const Eigen::Vector3d apart = found.on_b - found.on_a;
  found.upper = apart.norm();
  if (!(found.upper > tolerance)) return std::nullopt;
  found.normal = apart / found.upper;
  found.lower = plane_gap(a, b, found.normal);
  const bool proved = std::abs(found.upper - found.lower) <= tolerance &&
                      is_on_surface(a, found.on_a, tolerance) &&
                      is_on_surface(b, found.on_b, tolerance);
  if (!proved) return std::nullopt;
  return found;
}

}  // namespace wristwise
