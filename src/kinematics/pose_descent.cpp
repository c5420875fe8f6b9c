#include "kinematics/pose_descent.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "wristwise/kinematics.hpp"

namespace wristwise {
namespace {

constexpr double kExact = 1e-13;  // m and rad; no step improves on it
constexpr int kMostSteps = 40;
constexpr int kMostSlowSteps = 4;
constexpr double kSlow = 0.5;       // of the squared residual that a step leaves over
constexpr double kLongestStep = 1;  // rad or m, of a joint
constexpr double kFirstDamping = 0.03;
constexpr double kMostDamping = 1e9;
constexpr double kLeastDamping = 1e-16;

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 6, 6>;

/// (F71) r = ((p* - p) / L, 2 vec(Q)), Q the unit quaternion of R* R^T: of length 2 sin(angle / 2).
struct Misfit {
  Vector6 residual = Vector6::Zero();
  double square = 0;

  bool within(double tolerance, double length) const {
    return residual.head<3>().norm() * length <= tolerance &&
           residual.tail<3>().norm() <= tolerance;
  }
};

Misfit measure(const ChainPose& chain, const Pose& target, double length) {
  const Eigen::Quaterniond turn(Eigen::Matrix3d(target.linear() * chain.tcp.linear().transpose()));
  Misfit misfit;
  misfit.residual.head<3>() = (target.translation() - chain.tcp.translation()) / length;
  misfit.residual.tail<3>() = turn.vec() * (turn.w() < 0 ? -2.0 : 2.0);
  misfit.square = misfit.residual.squaredNorm();
  return misfit;
}

/// (F71) min |J dq - r|^2 + damping |dq|^2, solved on the smaller of the two sides.
JointVector damped_step(const Jacobian& jacobian, const Vector6& residual, double damping) {
  if (jacobian.cols() < 6) {
    Square normal = jacobian.transpose() * jacobian;
    normal.diagonal().array() += damping;
    return Eigen::LDLT<Square>(normal).solve(jacobian.transpose() * residual);
  }
  Matrix6 normal = jacobian * jacobian.transpose();
  normal.diagonal().array() += damping;
  return jacobian.transpose() * Eigen::LDLT<Matrix6>(normal).solve(residual);
}

class Descent {
 public:
  Descent(const Robot& robot, const Pose& target, const DescentRules& rules)
      : robot_(robot), target_(target), rules_(rules) {}

  bool run(JointVector& q) const {
    ChainPose chain;
    forward_kinematics(robot_, q, chain);
    Misfit misfit = measure(chain, target_, rules_.length);
    double factor = kFirstDamping;
    int slow = 0;
    for (int step = 0; step < kMostSteps && !misfit.within(kExact, rules_.length); ++step) {
      const JointVector next = q + limited_step(chain, misfit, factor * misfit.square, q);
      ChainPose next_chain;
      forward_kinematics(robot_, next, next_chain);
      const Misfit next_misfit = measure(next_chain, target_, rules_.length);
      if (!(next_misfit.square < kSlow * misfit.square) && ++slow > kMostSlowSteps) break;
      if (next_misfit.square < misfit.square) {
        q = next;
        misfit = next_misfit;
        chain = next_chain;
        factor /= 4;
      } else {
        if (misfit.within(rules_.tolerance, rules_.length)) break;
        factor = std::max(factor, kLeastDamping / misfit.square) * 8;
        if (factor > kMostDamping) break;
      }
    }
    return misfit.within(rules_.tolerance, rules_.length);
  }

 private:
  /// Joints at a bound that the step would push outwards are held, the others make up for them.
  JointVector limited_step(const ChainPose& chain, const Misfit& misfit, double damping,
                           const JointVector& q) const {
    Jacobian jacobian = geometric_jacobian(robot_, chain);
    jacobian.topRows<3>() /= rules_.length;
    JointVector step;
    for (bool held = true; held;) {
      step = damped_step(jacobian, misfit.residual, damping + kLeastDamping);
      held = false;
      for (Eigen::Index j = 0; j < q.size(); ++j) {
        const bool outwards =
            (step[j] > 0 && q[j] >= rules_.upper[j]) || (step[j] < 0 && q[j] <= rules_.lower[j]);
        if (!outwards || jacobian.col(j).isZero(0)) continue;
        jacobian.col(j).setZero();
        held = true;
      }
    }
    const double longest = step.cwiseAbs().maxCoeff();
    if (longest > kLongestStep) step *= kLongestStep / longest;
    return (q + step).cwiseMax(rules_.lower).cwiseMin(rules_.upper) - q;
  }

  const Robot& robot_;
  const Pose& target_;
  const DescentRules& rules_;
};

}  // namespace

bool descend_to_pose(const Robot& robot, const Pose& target, const DescentRules& rules,
                     JointVector& q) {
  q = q.cwiseMax(rules.lower).cwiseMin(rules.upper);
  return Descent(robot, target, rules).run(q);
}

}  // namespace wristwise
