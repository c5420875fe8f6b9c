#pragma once

#include <array>

#include "task/arc_length.hpp"
#include "task/path_point.hpp"

namespace wristwise {

/// A corner rounded off (F23): a quintic Bezier curve that takes over position, tangent and
/// curvature at both ends, run at constant speed. The frame takes over the rate of turn at both
/// ends; where that is zero it turns about one axis (F25).
class CornerBlend final : public SeamCurve {
 public:
  /// @param from, to where the piece before is left and the piece after is joined
  /// @param distance m, of either from the corner
  CornerBlend(const PathPoint& from, const PathPoint& to, double distance);

  double length() const override { return arc_length_.total(); }
  Pose frame_at(double fraction) const override;

 private:
  Eigen::Matrix3d orientation(double fraction) const;

  Eigen::Matrix3d start_;
  std::array<Eigen::Vector3d, 6> control_;
  ArcLength arc_length_;
  Eigen::Vector3d before_, after_;  ///< rad, by the rates of turn at the ends; base and last frame
  Eigen::AngleAxisd gap_;           ///< what is left to turn
};

}  // namespace wristwise
