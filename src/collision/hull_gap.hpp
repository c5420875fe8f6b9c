#pragma once

#include "collision/part.hpp"
#include "wristwise/geometry.hpp"

namespace wristwise {

/// How far the points of a hull are from a part: the largest distance lies between the bounds.
struct HullGap {
  double lower = 0, upper = 0;                   ///< m
  Eigen::Vector3d at = Eigen::Vector3d::Zero();  ///< a point of the hull that is `lower` away
};

/// Branch and bound over boxes (F40): until `upper` is no more than `enough`, or than half as much
/// again as `lower`.
/// @param budget measurements left; it is reduced, and ends the search when spent
HullGap hull_gap(const ConvexHull& hull, const Part& part, double enough, long& budget);

}  // namespace wristwise
