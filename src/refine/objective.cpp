#include "refine/objective.hpp"

#include <algorithm>
#include <cmath>

#include "refine/banded_qr.hpp"
#include "refine/gauss_quadrature.hpp"
#include "wristwise/error.hpp"
#include "wristwise/kinematics.hpp"

namespace wristwise {

namespace {

std::size_t interval_at(const Task& task, double t) {
  const auto& waypoints = task.waypoints;
  const auto after =
      std::upper_bound(waypoints.begin() + 1, waypoints.end() - 1, t,
                       [](double time, const Waypoint& waypoint) { return time < waypoint.time; });
  return static_cast<std::size_t>(after - waypoints.begin()) - 1;
}

/// The terms of the TCP's deviation, over a time `width` (s).
void add_deviation_terms(const ObjectiveWeights& weights, const Robot& robot,
                         const ToleranceBox& box, const Pose& frame, const JointVector& q,
                         double width, ObjectiveTerms& terms) {
  const Vector6 e = deviation(box, frame, tcp_pose(robot, q));
  terms.euler += width * (weights.alpha * e[3] * e[3] + weights.beta * e[4] * e[4]);
  terms.position += width * weights.position * e.head<3>().squaredNorm();
}

double posture_density(const ObjectiveWeights& weights, const JointVector& q) {
  return weights.derivative[0] * weights.joint.cwiseProduct(q - weights.posture).squaredNorm();
}

double singularity_density(const ObjectiveWeights& weights, const Robot& robot,
                           const JointVector& q) {
  ChainPose chain;
  forward_kinematics(robot, q, chain);
  return weights.singularity * std::pow(wrist_alignment(robot, chain, nullptr), 8);
}

bool sees_deviation(const ObjectiveWeights& weights) {
  return weights.alpha > 0 || weights.beta > 0 || weights.position > 0;
}

bool depends_on_posture(const ObjectiveWeights& weights) {
  return sees_deviation(weights) || weights.derivative[0] > 0 || weights.singularity > 0 ||
         !weights.own.empty();
}

/// The terms of a posture by itself at a time (s), over a time `width` (s).
void add_posture_terms(const ObjectiveWeights& weights, const Robot& robot, double time,
                       const JointVector& q, double width, ObjectiveTerms& terms) {
  for (const PostureResidual& residual : weights.own)
    terms.own += width * std::pow(own_residual(residual, time, q, nullptr), 2);
  terms.posture += width * posture_density(weights, q);
  if (weights.singularity > 0) terms.singularity += width * singularity_density(weights, robot, q);
}

std::vector<PosturePoint> posture_points(double weight, const SplineBasis& basis) {
  std::vector<PosturePoint> points;
  for (const QuadraturePoint& quadrature : gauss_points(basis.breakpoints())) {
    points.push_back(
        {quadrature.time, basis.at(quadrature.time), std::sqrt(quadrature.weight * weight)});
  }
  return points;
}

/// @param integral element k of |W q^(k)|^2, k = 1 .. 3
void set_derivative_terms(const ObjectiveWeights& weights, const std::array<double, 4>& integral,
                          ObjectiveTerms& terms) {
  terms.joint_motion = weights.derivative[1] * integral[1];
  terms.acceleration = weights.derivative[2] * integral[2];
  terms.jerk = weights.derivative[3] * integral[3];
}

}  // namespace

ObjectiveWeights objective_weights(const CostOptions& cost, double smoothing_time, int joints) {
  const double tau = smoothing_time;
  ObjectiveWeights weights;
  weights.own = cost.posture_residuals;
  weights.derivative = {cost.preferred_posture.empty() ? 0 : cost.posture / (tau * tau),
                        cost.joint_motion, cost.acceleration * std::pow(tau, 2),
                        cost.jerk * std::pow(tau, 4)};
  weights.singularity = cost.singularity_refine / (tau * tau);
  weights.beta = cost.euler_refine / (tau * tau);
  weights.alpha = weights.beta * cost.euler_eta * cost.euler_eta;
  weights.position = cost.position_refine / (tau * tau);
  weights.joint = JointVector::Ones(joints);
  for (std::size_t j = 0; j < cost.joint_weights.size(); ++j) {
    weights.joint[static_cast<Eigen::Index>(j)] = cost.joint_weights[j];
  }
  weights.posture = JointVector::Zero(joints);
  for (std::size_t j = 0; j < cost.preferred_posture.size(); ++j) {
    weights.posture[static_cast<Eigen::Index>(j)] = cost.preferred_posture[j];
  }
  return weights;
}

ObjectiveTerms objective_terms(const ObjectiveWeights& weights, const Robot& robot,
                               const Task& task, const Spline& spline) {
  ObjectiveTerms terms;
  std::array<double, 4> integral{};
  for (const QuadraturePoint& point : gauss_points(spline.basis.breakpoints())) {
    for (int k = 1; k <= 3; ++k) {
      integral[static_cast<std::size_t>(k)] +=
          point.weight * weights.joint.cwiseProduct(spline.evaluate(point.time, k)).squaredNorm();
    }
    if (!depends_on_posture(weights)) continue;
    const JointVector q = spline.evaluate(point.time);
    add_posture_terms(weights, robot, point.time, q, point.weight, terms);
    if (!sees_deviation(weights)) continue;
    if (const auto box = task.tolerance_between(interval_at(task, point.time))) {
      add_deviation_terms(weights, robot, *box, task.seam.frame_at(point.time), q, point.weight,
                          terms);
    }
  }
  set_derivative_terms(weights, integral, terms);
  return terms;
}

// (F13) integral |q^(k)|^2 dt ~ sum_i |k! [q_i .. q_i+k]|^2 (t_i+k - t_i) / k; with equal steps h
// this is the sum of squared k-th differences over h^(2k-1).
ObjectiveTerms objective_terms(const ObjectiveWeights& weights, const Robot& robot,
                               const Task& task, const JointPath& path) {
  ObjectiveTerms terms;
  std::array<double, 4> integral{};
  for (int k = 1; k <= 3; ++k) {
    const auto differences = divided_differences(path, k);
    for (std::size_t i = 0; i < differences.size(); ++i) {
      const double width = (path.times[i + static_cast<std::size_t>(k)] - path.times[i]) / k;
      integral[static_cast<std::size_t>(k)] +=
          width * weights.joint.cwiseProduct(differences[i]).squaredNorm();
    }
  }
  for (std::size_t i = 0; depends_on_posture(weights) && i < path.size(); ++i) {
    const double before = i > 0 ? path.times[i] - path.times[i - 1] : 0;
    const double after = i + 1 < path.size() ? path.times[i + 1] - path.times[i] : 0;
    const double width = 0.5 * (before + after);
    add_posture_terms(weights, robot, path.times[i], path.positions[i], width, terms);
    const Waypoint& waypoint = task.waypoints[i];
    if (!sees_deviation(weights) || waypoint.joints) continue;
    add_deviation_terms(weights, robot, waypoint.tolerance, waypoint.frame, path.positions[i],
                        width, terms);
  }
  set_derivative_terms(weights, integral, terms);
  return terms;
}

std::vector<ObjectiveRow> objective_rows(const ObjectiveWeights& weights,
                                         const SplineBasis& basis) {
  const auto points = gauss_points(basis.breakpoints());
  auto next = points.begin();
  BandedQr qr(0);
  BandedQr::Rows rows(4 * kGaussPoints, BandedQr::kLocal);
  const Eigen::MatrixXd nothing(4 * kGaussPoints, 0);
  for (int span = 0; span < basis.span_count(); ++span) {
    for (Eigen::Index i = 0; i < kGaussPoints; ++i) {
      const QuadraturePoint& point = *next++;
      const SplineBasis::Values values = basis.at(point.time);
      for (int k = 0; k < 4; ++k) {
        rows.row(4 * i + k) =
            std::sqrt(point.weight * weights.derivative[static_cast<std::size_t>(k)]) *
            values.derivatives.col(k).transpose();
      }
    }
    qr.add_span(rows, nothing);
  }
  std::vector<ObjectiveRow> result;
  for (const BandedQr::Row& row : qr.finish()) result.push_back({row.first, row.coefficients});
  return result;
}

std::vector<DeviationPoint> deviation_points(const ObjectiveWeights& weights, const Task& task,
                                             const SplineBasis& basis) {
  std::vector<DeviationPoint> points;
  if (!sees_deviation(weights)) return points;
  for (const QuadraturePoint& quadrature : gauss_points(basis.breakpoints())) {
    const auto box = task.tolerance_between(interval_at(task, quadrature.time));
    if (!box) continue;
    DeviationPoint point;
    point.time = quadrature.time;
    point.basis = basis.at(quadrature.time);
    point.frame = task.seam.frame_at(quadrature.time);
    point.tolerance = *box;
    point.sqrt_weights.head<3>().setConstant(std::sqrt(quadrature.weight * weights.position));
    point.sqrt_weights[3] = std::sqrt(quadrature.weight * weights.alpha);
    point.sqrt_weights[4] = std::sqrt(quadrature.weight * weights.beta);
    points.push_back(point);
  }
  return points;
}

std::vector<PosturePoint> singularity_points(const ObjectiveWeights& weights,
                                             const SplineBasis& basis) {
  if (weights.singularity <= 0) return {};
  return posture_points(weights.singularity, basis);
}

std::vector<PosturePoint> own_points(const ObjectiveWeights& weights, const SplineBasis& basis) {
  if (weights.own.empty()) return {};
  return posture_points(1, basis);
}

double own_residual(const PostureResidual& residual, double time, const JointVector& q,
                    JointVector* gradient) {
  const std::string where = "cost.posture_residuals at " + std::to_string(time) + " s";
  const double value = residual(time, q, gradient);
  if (!std::isfinite(value)) throw InvalidInput(where, "a value that is not finite");
  if (gradient == nullptr) return value;
  if (gradient->size() != q.size())
    throw InvalidInput(where, "a gradient of " + std::to_string(gradient->size()) + " values",
                       "one per joint");
  if (!gradient->allFinite()) throw InvalidInput(where, "a gradient that is not finite");
  return value;
}

// (F32) a = a_(n-2), b = a_n: only the joint between them turns one without the other, and
// d(a . b) / dq_(n-1) = a . (a_(n-1) x b).
double wrist_alignment(const Robot& robot, const ChainPose& chain, JointVector* derivative) {
  const int n = chain.joint_count;
  if (derivative != nullptr) derivative->setZero(n);
  if (n < 3) return 0;
  const auto last = static_cast<std::size_t>(n - 1);
  const Eigen::Vector3d &a = chain.axes[last - 2], &b = chain.axes[last];
  if (derivative != nullptr && robot.joints()[last - 1].type != JointType::prismatic)
    (*derivative)[n - 2] = a.dot(chain.axes[last - 1].cross(b));
  return a.dot(b);
}

}  // namespace wristwise
