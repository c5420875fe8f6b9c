#include "refine/objective.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "refine/gauss_quadrature.hpp"
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

double euler_density(const ObjectiveWeights& weights, const Robot& robot, const ToleranceBox& box,
                     const Pose& frame, const JointVector& q) {
  const Vector6 e = deviation(box, frame, tcp_pose(robot, q));
  return weights.alpha * e[3] * e[3] + weights.beta * e[4] * e[4];
}

bool has_euler(const ObjectiveWeights& weights) { return weights.alpha > 0 || weights.beta > 0; }

}  // namespace

ObjectiveWeights objective_weights(const CostOptions& cost, double smoothing_time, int joints) {
  const double tau = smoothing_time;
  ObjectiveWeights weights;
  weights.derivative = {0, cost.joint_motion, cost.acceleration * std::pow(tau, 2),
                        cost.jerk * std::pow(tau, 4)};
  weights.beta = cost.euler_refine / (tau * tau);
  weights.alpha = weights.beta * cost.euler_eta * cost.euler_eta;
  weights.joint = JointVector::Ones(joints);
  for (std::size_t j = 0; j < cost.joint_weights.size(); ++j) {
    weights.joint[static_cast<Eigen::Index>(j)] = cost.joint_weights[j];
  }
  return weights;
}

ObjectiveTerms objective_terms(const ObjectiveWeights& weights, const Robot& robot,
                               const Task& task, const Spline& spline) {
  std::array<double, 4> integral{};
  for (const QuadraturePoint& point : gauss_points(spline.basis.breakpoints())) {
    for (int k = 1; k <= 3; ++k) {
      integral[static_cast<std::size_t>(k)] +=
          point.weight * weights.joint.cwiseProduct(spline.evaluate(point.time, k)).squaredNorm();
    }
    if (!has_euler(weights)) continue;
    if (const auto box = task.tolerance_between(interval_at(task, point.time))) {
      integral[0] +=
          point.weight * euler_density(weights, robot, *box, task.seam.frame_at(point.time),
                                       spline.evaluate(point.time));
    }
  }
  return {weights.derivative[1] * integral[1], weights.derivative[2] * integral[2],
          weights.derivative[3] * integral[3], integral[0]};
}

// (F13) integral |q^(k)|^2 dt ~ sum_i |k! [q_i .. q_i+k]|^2 (t_i+k - t_i) / k; with equal steps h
// this is the sum of squared k-th differences over h^(2k-1).
ObjectiveTerms objective_terms(const ObjectiveWeights& weights, const Robot& robot,
                               const Task& task, const JointPath& path) {
  std::array<double, 4> integral{};
  for (int k = 1; k <= 3; ++k) {
    const auto differences = divided_differences(path, k);
    for (std::size_t i = 0; i < differences.size(); ++i) {
      const double width = (path.times[i + static_cast<std::size_t>(k)] - path.times[i]) / k;
      integral[static_cast<std::size_t>(k)] +=
          width * weights.joint.cwiseProduct(differences[i]).squaredNorm();
    }
  }
  for (std::size_t i = 0; has_euler(weights) && i < path.size(); ++i) {
    const Waypoint& waypoint = task.waypoints[i];
    if (waypoint.joints) continue;
    const double before = i > 0 ? path.times[i] - path.times[i - 1] : 0;
    const double after = i + 1 < path.size() ? path.times[i + 1] - path.times[i] : 0;
    integral[0] +=
        0.5 * (before + after) *
        euler_density(weights, robot, waypoint.tolerance, waypoint.frame, path.positions[i]);
  }
  return {weights.derivative[1] * integral[1], weights.derivative[2] * integral[2],
          weights.derivative[3] * integral[3], integral[0]};
}

std::vector<SpanFactor> span_factors(const ObjectiveWeights& weights, const SplineBasis& basis) {
  constexpr int kPoints = 5;
  const auto points = gauss_points(basis.breakpoints());
  std::vector<SpanFactor> factors;
  for (int span = 0; span < basis.span_count(); ++span) {
    Eigen::Matrix<double, 3 * kPoints, SplineBasis::kLocal> rows;
    for (int i = 0; i < kPoints; ++i) {
      const QuadraturePoint& point =
          points[static_cast<std::size_t>(span) * kPoints + static_cast<std::size_t>(i)];
      const SplineBasis::Values values = basis.at(point.time);
      for (int k = 1; k <= 3; ++k) {
        rows.row(3 * i + k - 1) =
            std::sqrt(point.weight * weights.derivative[static_cast<std::size_t>(k)]) *
            values.derivatives.col(k).transpose();
      }
    }
    const Eigen::HouseholderQR<decltype(rows)> qr(rows);
    factors.emplace_back(
        qr.matrixQR().topRows<SplineBasis::kLocal>().triangularView<Eigen::Upper>());
  }
  return factors;
}

std::vector<EulerPoint> euler_points(const ObjectiveWeights& weights, const Task& task,
                                     const SplineBasis& basis) {
  std::vector<EulerPoint> points;
  if (!has_euler(weights)) return points;
  for (const QuadraturePoint& quadrature : gauss_points(basis.breakpoints())) {
    const auto box = task.tolerance_between(interval_at(task, quadrature.time));
    if (!box) continue;
    EulerPoint point;
    point.time = quadrature.time;
    point.basis = basis.at(quadrature.time);
    point.frame = task.seam.frame_at(quadrature.time);
    point.tolerance = *box;
    point.sqrt_alpha = std::sqrt(quadrature.weight * weights.alpha);
    point.sqrt_beta = std::sqrt(quadrature.weight * weights.beta);
    points.push_back(point);
  }
  return points;
}

}  // namespace wristwise
