#pragma once

#include "wristwise/seam.hpp"

namespace wristwise {

/// How a path passes one of its points, in the base frame. A turn on the spot has no tangent: it
/// and what depends on it are zero.
struct PathPoint {
  Pose frame = Pose::Identity();
  Eigen::Vector3d tangent = Eigen::Vector3d::Zero();    ///< unit, the way it is run
  Eigen::Vector3d curvature = Eigen::Vector3d::Zero();  ///< 1/m, second derivative by arc length
  Eigen::Vector3d turning = Eigen::Vector3d::Zero();    ///< rad/m, of the frame by arc length
};

/// @param piece a line or an arc
PathPoint path_point(const SeamPiece& piece, double fraction);

/// The part of a line or an arc between two fractions; its times are not set.
SeamPiece part_of(const SeamPiece& piece, double from, double to);

}  // namespace wristwise
