#pragma once

#include "collision/placed_shape.hpp"

namespace wristwise {

/// Signed distance of two shapes; the sign contract is PairDistance's.
struct SignedDistance {
  double distance = 0;
  Eigen::Vector3d point_a, point_b, normal;
};

/// Signed distance of two convex shapes, exact to 1e-6 m for shapes of up to a few metres, whatever
/// the poses. Spheres against spheres, boxes and cylinders in closed form; separated boxes and
/// cylinders by FCL where its answer can be proved (fcl_nearest_points.hpp); the rest by support
/// functions, with a lower and an upper bound that close (nearest_points.hpp, penetration.hpp).
/// FCL 0.7 is not asked for signed distances: they do not return for concentric shapes, and abort
/// or throw near contact.
SignedDistance signed_distance(const PlacedShape& a, const PlacedShape& b);

}  // namespace wristwise
