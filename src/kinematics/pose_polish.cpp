#include "kinematics/pose_polish.hpp"

#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <utility>

#include "wristwise/kinematics.hpp"

namespace wristwise {
namespace {

constexpr double kTolerance = 1e-12;
constexpr int kNewtonSteps = 8;
constexpr int kDampedSteps = 80;
/// Solutions nearer than this (rad) are one: at a double root 1e-12 in the pose is 1e-6 in a joint.
constexpr double kSameSolution = 1e-6;

using Matrix6 = Eigen::Matrix<double, 6, 6>;

struct Misfit {
  Vector6 residual = Vector6::Zero();  // m, rad, in base
  bool opposite = false;               // the orientations differ by more than 90 deg

  double norm() const { return residual.norm(); }
  bool solved() const {
    return !opposite && residual.head<3>().norm() <= kTolerance &&
           residual.tail<3>().norm() <= kTolerance;
  }
};

Misfit measure(const Robot& robot, const Pose& target, const JointVector& q, ChainPose& chain) {
  forward_kinematics(robot, q, chain);
  const Eigen::Matrix3d turn = target.linear() * chain.tcp.linear().transpose();
  Misfit misfit;
  misfit.residual.head<3>() = target.translation() - chain.tcp.translation();
  misfit.residual.tail<3>() << turn(2, 1) - turn(1, 2), turn(0, 2) - turn(2, 0),
      turn(1, 0) - turn(0, 1);
  misfit.residual.tail<3>() /= 2;
  misfit.opposite = turn.trace() < 1;
  return misfit;
}

/// Quadratic convergence away from singular postures; gives up where the residual does not shrink.
bool newton(const Robot& robot, const Pose& target, JointVector& q) {
  ChainPose chain;
  Misfit misfit = measure(robot, target, q, chain);
  for (int step = 0; step < kNewtonSteps && !misfit.solved(); ++step) {
    const Matrix6 jacobian = geometric_jacobian(robot, chain);
    q += Eigen::PartialPivLU<Matrix6>(jacobian).solve(misfit.residual);
    const double before = misfit.norm();
    misfit = measure(robot, target, q, chain);
    if (!(misfit.norm() < before / 4)) break;
  }
  return misfit.solved();
}

/// min |J dq - r|^2 + damping^2 |dq|^2, by a QR factorisation so that the condition is not squared.
Vector6 damped_step(const Matrix6& jacobian, const Vector6& residual, double damping) {
  Eigen::Matrix<double, 12, 6> system;
  system << jacobian, damping * Matrix6::Identity();
  Eigen::Matrix<double, 12, 1> right = Eigen::Matrix<double, 12, 1>::Zero();
  right.head<6>() = residual;
  return Eigen::HouseholderQR<Eigen::Matrix<double, 12, 6>>(system).solve(right);
}

/// Levenberg-Marquardt with damping^2 in proportion to |r|^2: it converges quadratically under an
/// error bound that holds at singular solutions too (Yamashita and Fukushima 2001).
bool levenberg_marquardt(const Robot& robot, const Pose& target, JointVector& q) {
  ChainPose chain;
  Misfit misfit = measure(robot, target, q, chain);
  double factor = 1;
  for (int step = 0; step < kDampedSteps && !misfit.solved(); ++step) {
    const Matrix6 jacobian = geometric_jacobian(robot, chain);
    const JointVector next =
        q + damped_step(jacobian, misfit.residual, factor * misfit.norm() + 1e-15);
    ChainPose next_chain;
    const Misfit next_misfit = measure(robot, target, next, next_chain);
    if (next_misfit.norm() < misfit.norm()) {
      q = next;
      misfit = next_misfit;
      chain = next_chain;
      factor /= 3;
    } else {
      factor *= 4;
    }
    if (!(factor < 1e12)) break;
  }
  return misfit.solved();
}

bool same_posture(const JointVector& a, const JointVector& b) {
  for (Eigen::Index j = 0; j < a.size(); ++j) {
    if (std::abs(wrap_angle(a[j] - b[j])) > kSameSolution) return false;
  }
  return true;
}

}  // namespace

bool polish_posture(const Robot& robot, const Pose& target, JointVector& q) {
  JointVector start = q;
  if (newton(robot, target, q)) return true;
  q = start;
  return levenberg_marquardt(robot, target, q);
}

void append_polished(const Robot& robot, const Pose& target, JointVector start, std::size_t first,
                     std::vector<JointVector>& branches) {
  if (!polish_posture(robot, target, start)) return;
  for (double& angle : start) angle = wrap_angle(angle);
  const bool known =
      std::any_of(branches.begin() + static_cast<std::ptrdiff_t>(first), branches.end(),
                  [&](const JointVector& other) { return same_posture(start, other); });
  if (!known) branches.push_back(std::move(start));
}

}  // namespace wristwise
