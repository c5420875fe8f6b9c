#pragma once

#include "kinematics/tcp_taylor.hpp"
#include "task/frame_taylor.hpp"
#include "wristwise/seam.hpp"

namespace wristwise {

/// The deviation (F3) of the TCP from the seam over an interval of time, enclosed for all t (F30).
/// The interval lies on one piece of the seam.
class DeviationEnclosure {
 public:
  /// @param joints the motion over [t0, t1] (s)
  /// @param box says in which frame and Euler sequence, and which angles are free
  DeviationEnclosure(const Robot& robot, const MotionPiece::Polynomials& joints, const Seam& seam,
                     double t0, double t1, const ToleranceBox& box);

  /// True only where the deviation is inside the box for all t. The box has the frame and the free
  /// angles of the constructor's; its bounds may differ.
  bool inside(const ToleranceBox& box) const;

  double distance() const;  ///< m, a bound on the distance from the path frame's origin, for all t
  double angle() const;     ///< rad, a bound on every angle that is not free, for all t; pi: any

 private:
  /// An angle by functions in the ratio of its cosine and sine, the factor between them >= 0.
  struct Angle {
    Taylor cosine, sine;
    bool inside(double lower, double upper) const;
    double largest() const;
  };
  bool middle_inside(double lower, double upper) const;

  void enclose_angles(const PoseTaylor& tcp, const FrameTaylor& frame);

  ToleranceBox box_;
  std::array<int, 3> order_;  ///< axes of the Euler sequence
  VectorTaylor position_;     ///< in the tolerance frame
  Angle first_, last_;
  Taylor middle_sine_;                    ///< of the TCP's middle angle
  Taylor nominal_sine_, nominal_cosine_;  ///< of the nominal one; 0 and 1 in the path frame
};

}  // namespace wristwise
