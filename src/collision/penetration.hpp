#pragma once

#include "collision/nearest_points.hpp"

namespace wristwise {

/// Signed distance of two cores that touch or overlap (at least one of them a solid), by the
/// expanding polytope algorithm (van den Bergen 2001). Negative: depth of penetration.
/// `normal` is the direction in which moving b frees it soonest; -lower is an upper bound of the
/// depth in any case (plane_gap), and -upper a lower bound.
CertifiedDistance penetration(const PlacedShape& a, const PlacedShape& b);

}  // namespace wristwise
