#pragma once

#include <array>
#include <vector>

#include "refine/spline.hpp"
#include "wristwise/kinematics.hpp"
#include "wristwise/options.hpp"
#include "wristwise/robot.hpp"
#include "wristwise/seam.hpp"

namespace wristwise {

/// The weights of one planning problem's objective (F14):
///   integral of w_v |W q'|^2 + w_a tau^2 |W q''|^2 + w_j tau^4 |W q'''|^2
///             + w_p / tau^2 |W (q - p)|^2 + w_s / tau^2 cos^8(wrist)
///             + w_e (eta^2 alpha^2 + beta^2) / tau^2 + w_x (x^2 + y^2 + z^2) / tau^2
///             + sum of r^2 over the caller's residuals,
/// W = diag(joint weights).
struct ObjectiveWeights {
  std::array<double, 4> derivative{};  ///< of |W q^(k)|^2, k = 1 .. 3; [0]: of |W (q - p)|^2
  double alpha = 0;                    ///< of alpha^2
  double beta = 0;                     ///< of beta^2
  double position = 0;                 ///< of x^2 + y^2 + z^2
  double singularity = 0;              ///< of cos^8 of the angle between the wrist's axes (F32)
  JointVector joint;                   ///< diagonal of W
  JointVector posture;                 ///< p; zero where there is none
  std::vector<PostureResidual> own;    ///< the caller's r(t, q)
};

ObjectiveWeights objective_weights(const CostOptions& cost, double smoothing_time, int joints);

/// The integrals of the terms, weighted.
struct ObjectiveTerms {
  double joint_motion = 0, acceleration = 0, jerk = 0, euler = 0, position = 0, posture = 0,
         singularity = 0, own = 0;
  double total() const {
    return joint_motion + acceleration + jerk + euler + position + posture + singularity + own;
  }
};

/// Of a curve, by quadrature.
ObjectiveTerms objective_terms(const ObjectiveWeights& weights, const Robot& robot,
                               const Task& task, const Spline& spline);

/// Of a path of points, by divided differences (F13).
ObjectiveTerms objective_terms(const ObjectiveWeights& weights, const Robot& robot,
                               const Task& task, const JointPath& path);

/// One row of the derivative and posture terms as a sum of squares (F14): their integral is the sum
/// over rows and joints j of (W_j sum_k coefficients[k] (c_j,first+k - p_j))^2, p the preferred
/// posture. As many rows as control points.
struct ObjectiveRow {
  int first = 0;  ///< index of the first control point
  Eigen::Matrix<double, 1, SplineBasis::kLocal> coefficients;
};

/// By a QR factorisation of the quadrature rows, span after span, so that the Gram matrix is never
/// formed and no digits are lost to its condition.
std::vector<ObjectiveRow> objective_rows(const ObjectiveWeights& weights, const SplineBasis& basis);

/// One quadrature point of the Euler and position terms: residuals sqrt(weight) times the deviation
/// at a time.
struct DeviationPoint {
  double time = 0;
  SplineBasis::Values basis;
  Pose frame = Pose::Identity();
  ToleranceBox tolerance;
  Vector6 sqrt_weights = Vector6::Zero();
};
std::vector<DeviationPoint> deviation_points(const ObjectiveWeights& weights, const Task& task,
                                             const SplineBasis& basis);

/// One quadrature point of a term that depends on the posture alone.
struct PosturePoint {
  double time = 0;
  SplineBasis::Values basis;
  double sqrt_weight = 0;
};
/// Of the singularity term: residual sqrt_weight * wrist_alignment^4.
std::vector<PosturePoint> singularity_points(const ObjectiveWeights& weights,
                                             const SplineBasis& basis);
/// Of the caller's terms: residuals sqrt_weight * r(t, q).
std::vector<PosturePoint> own_points(const ObjectiveWeights& weights, const SplineBasis& basis);

/// r(t, q) of the caller, and its gradient where that is not null.
/// @throws InvalidInput where either is not finite, or the gradient not one value per joint.
double own_residual(const PostureResidual& residual, double time, const JointVector& q,
                    JointVector* gradient);

/// a_(n-2) . a_n, the cosine of the angle between the axes that line up where a spherical wrist is
/// singular, and its derivative with respect to q (F32); 0 for chains of fewer than three joints.
double wrist_alignment(const Robot& robot, const ChainPose& chain, JointVector* derivative);

}  // namespace wristwise
