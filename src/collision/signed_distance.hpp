#pragma once

#include "collision/placed_shape.hpp"

namespace wristwise {

/// Signed distance of two shapes; the sign contract is PairDistance's.
struct SignedDistance {
  double distance = 0;
  Eigen::Vector3d point_a, point_b, normal;
};

/// Signed distance of two convex shapes, exact to 1e-6 m for shapes of up to a few metres, whatever
/// the poses. Spheres against spheres, boxes and cylinders in closed form; the rest by support
/// functions, with a lower and an upper bound that close (nearest_points.hpp, penetration.hpp).
///
/// Why not FCL 0.7: its signed distance does not return for concentric shapes, and aborts or throws
/// near contact; its distance of separated shapes comes without a proof, so that the certified
/// search is needed behind it, and alone that is two to four times as fast. The tests compare the
/// two.
SignedDistance signed_distance(const PlacedShape& a, const PlacedShape& b);

}  // namespace wristwise
