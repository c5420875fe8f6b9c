#pragma once

#include "collision/placed_shape.hpp"

namespace wristwise {

/// Nearest points of two separated cores, with a certificate: `lower` <= distance <= `upper`.
struct CertifiedDistance {
  double lower = 0;                                   ///< from a separating plane
  double upper = 0;                                   ///< |on_b - on_a|
  Eigen::Vector3d normal = Eigen::Vector3d::UnitX();  ///< of that plane, from a to b
  Eigen::Vector3d on_a = Eigen::Vector3d::Zero();
  Eigen::Vector3d on_b = Eigen::Vector3d::Zero();
};

/// How far apart the planes of normal `normal` (unit, from a to b) that touch the cores are; never
/// more than their signed distance, and equal to it for the best normal.
double plane_gap(const PlacedShape& a, const PlacedShape& b, const Eigen::Vector3d& normal);

/// Narrows the certificate to 1e-9 m where rounding allows, by the algorithm of Gilbert, Johnson
/// and Keerthi (1988). `upper` is zero where the cores touch or overlap; the
/// points are then the same, somewhere in the overlap.
/// @param normal unit; where to look first
CertifiedDistance nearest_points(const PlacedShape& a, const PlacedShape& b,
                                 const Eigen::Vector3d& normal);

}  // namespace wristwise
