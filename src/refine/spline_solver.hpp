#pragma once

#include <string>
#include <vector>

#include "refine/limit_constraint.hpp"
#include "refine/objective.hpp"
#include "refine/point_constraint.hpp"
#include "wristwise/monitor.hpp"

namespace wristwise {

/// The augmented Lagrangian of one round, for the control points of a spline.
struct AugmentedProblem {
  const Robot& robot;
  ClearanceChecker& checker;
  const JointVector& joint_weight;
  const std::vector<SpanFactor>& span_factors;
  const std::vector<EulerPoint>& euler_points;
  const std::vector<PointConstraint>& points;
  const std::vector<LimitConstraint>& limits;
  double mu = 1;       ///< of constraints in m and rad
  double rate_mu = 0;  ///< of velocity, acceleration and jerk as shares of their limits; 0: none
};

struct InnerSummary {
  int iterations = 0;
  int evaluations = 0;
  bool converged = false;  ///< false: stopped by the iteration limit, or no progress was possible
  std::string message;
};

/// Minimises the augmented Lagrangian over the control points, in place, by Levenberg-Marquardt
/// with sparse normal equations (Ceres). One thread: the result is reproducible to the bit.
InnerSummary minimise(const AugmentedProblem& problem, Spline& spline, int max_iterations,
                      double function_tolerance, const Monitor& monitor);

}  // namespace wristwise
