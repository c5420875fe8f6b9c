#pragma once

#include <optional>

#include "collision/nearest_points.hpp"

namespace wristwise {

/// FCL's nearest points of two boxes or cylinders that do not touch, with a certificate from our
/// own support functions. FCL is asked only what it answers without aborting the process:
/// `collide`, and the plain distance of separated shapes. nullopt for other shapes, for shapes that
/// touch, and where the certificate does not close to `tolerance` (m).
std::optional<CertifiedDistance> fcl_nearest_points(const PlacedShape& a, const PlacedShape& b,
                                                    double tolerance);

}  // namespace wristwise
