#pragma once

#include <ceres/cost_function.h>

#include "refine/limit_constraint.hpp"
#include "refine/objective.hpp"
#include "refine/point_constraint.hpp"

namespace wristwise {

/// The residuals of the augmented Lagrangian as functions of consecutive control points, each a
/// parameter block of one value per joint, with analytic Jacobians. The caller owns what is
/// returned; arguments held by reference must outlive it.

/// One row of the objective (F14): a residual for each joint.
ceres::CostFunction* objective_cost(const ObjectiveRow& row, const ObjectiveWeights& weights);

/// sqrt(weight) cos^4(wrist) at a quadrature point (F32).
ceres::CostFunction* singularity_cost(const Robot& robot, const PosturePoint& point);

/// sqrt(weight) r at a quadrature point, for each of the caller's residuals (F14).
ceres::CostFunction* own_cost(const ObjectiveWeights& weights, const PosturePoint& point);

/// sqrt(weight) (alpha, beta) at a quadrature point (F14).
ceres::CostFunction* deviation_cost(const Robot& robot, const DeviationPoint& point);

/// The rows of a point constraint (F16).
ceres::CostFunction* point_cost(const Robot& robot, ClearanceChecker& checker,
                                const PointConstraint& point, double mu);

/// The rows of a limit constraint (F15, F16).
ceres::CostFunction* limit_cost(const LimitConstraint& limit, int joints, double mu);

}  // namespace wristwise
