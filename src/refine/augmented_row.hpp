#pragma once

#include <algorithm>
#include <cmath>

namespace wristwise {

/// One constraint lower <= c(q) <= upper of the augmented Lagrangian (F16). Equalities have
/// lower == upper, one-sided constraints an infinite bound.
///
/// With s = c + lambda / mu and its projection P(s) onto [lower, upper], the term of the augmented
/// Lagrangian is mu / 2 |s - P(s)|^2, and the multiplier's update is lambda <- mu (s - P(s))
/// (Rockafellar 1973; Nocedal & Wright, Numerical Optimization, eq. 17.56, for both sides at once).
struct AugmentedRow {
  double lower = 0;
  double upper = 0;
  double multiplier = 0;

  /// sqrt(mu) (s - P(s)); `slope` receives its derivative with respect to c.
  double residual(double c, double mu, double& slope) const {
    const double outside = distance_outside(c, mu);
    const bool is_equality = lower == upper;
    slope = is_equality || outside != 0 ? std::sqrt(mu) : 0.0;
    return std::sqrt(mu) * outside;
  }
  void update_multiplier(double c, double mu) { multiplier = mu * distance_outside(c, mu); }

  double violation(double c) const { return std::max({0.0, lower - c, c - upper}); }

  /// Whether every c at or above `c` gives no residual.
  bool is_slack_above(double c, double mu) const {
    return std::isinf(upper) && c + multiplier / mu > lower;
  }

 private:
  double distance_outside(double c, double mu) const {
    const double s = c + multiplier / mu;
    return s - std::clamp(s, lower, upper);
  }
};

}  // namespace wristwise
