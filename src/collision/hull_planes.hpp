#pragma once

#include <vector>

#include "wristwise/geometry.hpp"

namespace wristwise {

/// The half-space { x : normal . x <= offset }.
struct Plane {
  Eigen::Vector3d normal;  ///< unit
  double offset = 0;       ///< m

  double height(const Eigen::Vector3d& point) const { return normal.dot(point) - offset; }
};

/// Half-spaces that hold the hull, one for each of its faces.
std::vector<Plane> hull_planes(const ConvexHull& hull);

double hull_volume(const ConvexHull& hull);  ///< m^3

}  // namespace wristwise
