#pragma once

#include <array>
#include <vector>

#include "refine/spline.hpp"
#include "wristwise/options.hpp"
#include "wristwise/robot.hpp"
#include "wristwise/seam.hpp"

namespace wristwise {

/// The weights of one planning problem's objective (F14):
///   integral of w_v |W q'|^2 + w_a tau^2 |W q''|^2 + w_j tau^4 |W q'''|^2
///             + w_e (eta^2 alpha^2 + beta^2) / tau^2,    W = diag(joint weights).
struct ObjectiveWeights {
  std::array<double, 4> derivative{};  ///< of |W q^(k)|^2, k = 1 .. 3; [0] unused
  double alpha = 0;                    ///< of alpha^2
  double beta = 0;                     ///< of beta^2
  JointVector joint;                   ///< diagonal of W
};

ObjectiveWeights objective_weights(const CostOptions& cost, double smoothing_time, int joints);

/// The integrals of joint motion, acceleration, jerk and Euler deviation, weighted.
struct ObjectiveTerms {
  double joint_motion = 0, acceleration = 0, jerk = 0, euler = 0;
  double total() const { return joint_motion + acceleration + jerk + euler; }
};

/// Of a curve, by quadrature.
ObjectiveTerms objective_terms(const ObjectiveWeights& weights, const Robot& robot,
                               const Task& task, const Spline& spline);

/// Of a path of points, by divided differences (F13).
ObjectiveTerms objective_terms(const ObjectiveWeights& weights, const Robot& robot,
                               const Task& task, const JointPath& path);

/// The derivative terms of one span as a sum of squares: |R c_j W_j|^2 over the joints j, c_j the
/// six control points of the span. R is the QR factor of the quadrature rows, so the Gram matrix
/// R^T R is never formed and no digits are lost to its condition.
using SpanFactor = Eigen::Matrix<double, SplineBasis::kLocal, SplineBasis::kLocal>;
std::vector<SpanFactor> span_factors(const ObjectiveWeights& weights, const SplineBasis& basis);

/// One quadrature point of the Euler term: residuals sqrt(weight) (alpha, beta) at a time.
struct EulerPoint {
  double time = 0;
  SplineBasis::Values basis;
  Pose frame = Pose::Identity();
  ToleranceBox tolerance;
  double sqrt_alpha = 0, sqrt_beta = 0;
};
std::vector<EulerPoint> euler_points(const ObjectiveWeights& weights, const Task& task,
                                     const SplineBasis& basis);

}  // namespace wristwise
