#pragma once

#include <Eigen/Core>
#include <vector>

#include "wristwise/trajectory.hpp"

namespace wristwise {

/// The quintic B-spline basis over given breakpoints, clamped at both ends: four times continuously
/// differentiable, six functions on each span, breakpoints + 4 control points in all.
class SplineBasis {
 public:
  static constexpr int kDegree = 5;
  static constexpr int kLocal = kDegree + 1;

  /// The functions that do not vanish at a time, and their derivatives.
  struct Values {
    int first = 0;                                 ///< index of the first control point
    Eigen::Matrix<double, kLocal, 4> derivatives;  ///< column k: k-th derivative, 1/s^k
  };

  /// @pre breakpoints (s) increase strictly; at least two
  explicit SplineBasis(std::vector<double> breakpoints);

  int control_count() const { return static_cast<int>(breakpoints_.size()) + kDegree - 1; }
  int span_count() const { return static_cast<int>(breakpoints_.size()) - 1; }
  const std::vector<double>& breakpoints() const { return breakpoints_; }
  /// Knot i, i = 0 .. control_count() + kDegree; the ends are kLocal-fold.
  double knot(int i) const { return knots_[static_cast<std::size_t>(i)]; }

  Values at(double t) const;

  /// The k-th derivative's control point i is sum_m weights[m] c[i + m], m = 0 .. k (F15).
  std::vector<double> derivative_weights(int derivative, int i) const;

 private:
  std::vector<double> breakpoints_;
  std::vector<double> knots_;
};

/// A joint motion: one column of control points for each basis function.
struct Spline {
  SplineBasis basis;
  Eigen::MatrixXd control;  ///< joints x control points

  JointVector evaluate(double t, int derivative = 0) const;
  JointVector value(const SplineBasis::Values& at) const;

  /// The piecewise quintic with the same value, velocity and acceleration at the given times: the
  /// same curve where every breakpoint is one of them.
  Trajectory sampled_at(const std::vector<double>& times) const;
};

/// The same curve with more breakpoints.
/// @pre `breakpoints` holds those of the spline
Spline with_breakpoints(const Spline& spline, std::vector<double> breakpoints);

/// Least-squares fit to a path; a trace of acceleration and jerk settles what the path leaves open.
/// Wiggles of the path that are shorter than about `smoothing` (s) are ironed out.
Spline fit_spline(const JointPath& path, std::vector<double> breakpoints, double smoothing = 0);

}  // namespace wristwise
