#pragma once

#include <cmath>

#include "wristwise/kinematics.hpp"
#include "wristwise/tolerance.hpp"

namespace wristwise {

/// A box of deviations, and how far a posture is outside it (F73).
struct DeviationCell {
  ToleranceBox box;  ///< says how deviations are measured
  Pose path_frame = Pose::Identity();
  Vector6 lower = Vector6::Zero(), upper = Vector6::Zero();  ///< m, rad; infinite where free

  /// The whole box.
  static DeviationCell of(const ToleranceBox& box, const Pose& path_frame) {
    return {box, path_frame, box.lower, box.upper};
  }

  bool is_fixed(int coordinate) const { return lower[coordinate] == upper[coordinate]; }
  bool is_free(int coordinate) const { return std::isinf(lower[coordinate]); }
  Vector6 middle() const;

  /// Deviation of a TCP pose, angles on the turn that is nearest to the middle of the cell.
  Vector6 measure(const Pose& tcp) const;

  /// Of a posture, with its derivative by the joints (F4).
  Vector6 measure(const Robot& robot, const JointVector& q, Jacobian& jacobian) const;

  /// e less the nearest point of the cell: zero inside.
  Vector6 outside(const Vector6& deviation) const;
};

}  // namespace wristwise
