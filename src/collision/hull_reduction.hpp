#pragma once

#include "wristwise/geometry.hpp"

namespace wristwise {

/// A hull of fewer vertices that contains the given one and reaches at most `error` (m) beyond it;
/// the given one where that saves little.
ConvexHull reduced_hull(const ConvexHull& hull, double error);

}  // namespace wristwise
