#pragma once

#include "collision/nearest_points.hpp"

namespace wristwise {

/// Looks for a normal with a greater plane_gap near `found.normal`, and along the axes of the
/// shapes: for shapes so regular (coaxial cylinders) that their depth is the same all round, where
/// the polytope runs out of room. `lower` never falls.
void search_normal(const PlacedShape& a, const PlacedShape& b, CertifiedDistance& found);

}  // namespace wristwise
