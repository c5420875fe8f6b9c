#pragma once

#include "task/taylor.hpp"
#include "wristwise/trajectory.hpp"

namespace wristwise {

/// A joint motion over [start, end] (s) whose joints are polynomials of degree 5 or less.
class MotionPiece {
 public:
  /// Columns: coefficients of s^0 .. s^5, s running from -1 to 1.
  using Polynomials = Trajectory::Polynomials;

  MotionPiece(double start, double end, const Polynomials& over_all);
  /// The straight joint-space move.
  MotionPiece(double start, double end, const JointVector& from, const JointVector& to);

  double start() const { return start_; }
  double end() const { return end_; }

  /// The same motion over [t0, t1], s running from -1 at t0 to 1 at t1. The posture in the middle
  /// is the first column.
  Polynomials over(double t0, double t1) const;
  JointVector posture(double t) const { return over(t, t).col(0); }

 private:
  double start_, end_;
  Polynomials over_all_;
};

/// Of one joint (F29).
Taylor polynomial_taylor(const MotionPiece::Polynomials& motion, int joint);

/// For each joint, a bound on |q(s) - q(0)|, s in [-1, 1].
JointVector spread(const MotionPiece::Polynomials& motion);

}  // namespace wristwise
