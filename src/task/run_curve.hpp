#pragma once

#include "task/path_point.hpp"
#include "wristwise/trajectory.hpp"

namespace wristwise {

/// A run-in or a run-out (F24): between rest and the speed at which the seam is passed. A quintic
/// over time in position and in the angle by which the frame is turned.
class RunCurve final : public SeamCurve {
 public:
  enum class Way { in, out };

  /// @param end of the seam, with the curvature that is to be met
  /// @param speed m/s, at the end of the seam
  /// @param rest where it is at rest, base frame, m
  /// @param duration s
  RunCurve(Way way, const PathPoint& end, double speed, const Eigen::Vector3d& rest,
           double duration);

  double length() const override { return length_; }
  Pose frame_at(double fraction) const override;

 private:
  Eigen::Matrix3d orientation_;  ///< at the end of the seam
  Eigen::Vector3d axis_;         ///< unit, base frame
  Trajectory motion_;            ///< x, y, z (m), angle (rad) over the fraction
  double length_ = 0;
};

}  // namespace wristwise
