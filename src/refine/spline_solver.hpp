#pragma once

#include <vector>

#include "refine/limit_constraint.hpp"
#include "refine/objective.hpp"
#include "refine/point_constraint.hpp"
#include "refine/stop.hpp"

namespace wristwise {

/// The augmented Lagrangian of one round, for the control points of a spline.
struct AugmentedProblem {
  const Robot& robot;
  ClearanceChecker& checker;
  const ObjectiveWeights& weights;
  const std::vector<ObjectiveRow>& objective_rows;
  const std::vector<DeviationPoint>& deviation_points;
  const std::vector<PosturePoint>& singularity_points;
  const std::vector<PosturePoint>& own_points;
  const std::vector<PointConstraint>& points;
  const std::vector<LimitConstraint>& limits;
  double mu = 1;       ///< of constraints in m and rad
  double rate_mu = 0;  ///< of velocity, acceleration and jerk as shares of their limits; 0: none
  /// Velocity and acceleration vanish there: the first, or last, three control points are one.
  bool rest_at_start = false, rest_at_end = false;
};

struct InnerOptions {
  int max_iterations = 40;
  double function_tolerance = 1e-8;
  double trust_region = 0;  ///< radius that an earlier round ended with; 0: none, a large one
};

struct InnerSummary {
  int iterations = 0;
  int evaluations = 0;
  bool converged = false;   ///< false: stopped by the iteration limit, or no progress was possible
  double trust_region = 0;  ///< radius at the end
};

/// Minimises the augmented Lagrangian over the control points, in place, by Levenberg-Marquardt
/// with sparse normal equations (Ceres). One thread: the result is reproducible to the bit.
InnerSummary minimise(const AugmentedProblem& problem, Spline& spline, const InnerOptions& options,
                      const Stop& stop);

}  // namespace wristwise
