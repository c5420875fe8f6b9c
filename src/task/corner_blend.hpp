#pragma once

#include <array>

#include "task/arc_length.hpp"
#include "task/path_point.hpp"

namespace wristwise {

/// A corner rounded off (F23): a quintic Bezier curve that takes over position, tangent and
/// curvature at both ends, run at constant speed. The frame goes over smoothly from the turning of
/// the piece before to that of the piece after.
class CornerBlend final : public SeamCurve {
 public:
  /// @param from, to where the piece before is left and the piece after is joined
  /// @param distance m, of either from the corner
  CornerBlend(const PathPoint& from, const PathPoint& to, double distance);

  double length() const override { return arc_length_.total(); }
  Pose frame_at(double fraction) const override;

 private:
  Eigen::Matrix3d orientation(double fraction) const;

  PathPoint from_, to_;
  std::array<Eigen::Vector3d, 6> control_;
  ArcLength arc_length_;
};

}  // namespace wristwise
