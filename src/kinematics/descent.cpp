#include "kinematics/descent.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

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

/// What is left of the way to the goal, m in units of the length and rad.
struct Rest {
  ChainPose chain;
  Vector6 residual = Vector6::Zero();
  double square = 0;

  bool within(double tolerance, double length) const {
    return residual.head<3>().norm() * length <= tolerance &&
           residual.tail<3>().norm() <= tolerance;
  }
};

/// (F71) r = ((p* - p) / L, 2 vec(Q)), Q the unit quaternion of R* R^T: of length 2 sin(angle / 2).
class PoseGoal {
 public:
  PoseGoal(const Robot& robot, const Pose& pose) : robot_(robot), pose_(pose) {}

  Vector6 residual(const ChainPose& chain) const {
    const Eigen::Quaterniond turn(Eigen::Matrix3d(pose_.linear() * chain.tcp.linear().transpose()));
    Vector6 rest;
    rest.head<3>() = pose_.translation() - chain.tcp.translation();
    rest.tail<3>() = turn.vec() * (turn.w() < 0 ? -2.0 : 2.0);
    return rest;
  }

  Jacobian jacobian(const ChainPose& chain) const { return geometric_jacobian(robot_, chain); }

 private:
  const Robot& robot_;
  const Pose& pose_;
};

/// (F73) r = e_lo - e for the coordinates without width; the others do not count.
class CellGoal {
 public:
  CellGoal(const Robot& robot, const DeviationCell& cell) : robot_(robot), cell_(cell) {}

  Vector6 residual(const ChainPose& chain) const {
    Vector6 rest = -cell_.outside(cell_.measure(chain.tcp));
    for (int k = 0; k < 6; ++k) {
      if (!cell_.is_fixed(k)) rest[k] = 0;
    }
    return rest;
  }

  Jacobian jacobian(const ChainPose& chain) const {
    Jacobian jacobian = deviation_jacobian(cell_.box, cell_.path_frame, chain.tcp,
                                           geometric_jacobian(robot_, chain));
    for (int k = 0; k < 6; ++k) {
      if (!cell_.is_fixed(k)) jacobian.row(k).setZero();
    }
    return jacobian;
  }

 private:
  const Robot& robot_;
  const DeviationCell& cell_;
};

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

template <class Goal>
class Descent {
 public:
  Descent(const Robot& robot, const Goal& goal, const DescentRules& rules)
      : robot_(robot), goal_(goal), rules_(rules) {}

  bool run(JointVector& q) const {
    q = q.cwiseMax(rules_.lower).cwiseMin(rules_.upper);
    Rest rest = measure(q);
    double factor = kFirstDamping;
    int slow = 0;
    for (int step = 0; step < kMostSteps && !rest.within(kExact, rules_.length); ++step) {
      const JointVector next = q + limited_step(rest, factor * rest.square + kLeastDamping, q);
      const Rest next_rest = measure(next);
      if (!(next_rest.square < kSlow * rest.square) && ++slow > kMostSlowSteps) break;
      if (next_rest.square < rest.square) {
        q = next;
        rest = next_rest;
        factor /= 4;
      } else {
        if (rest.within(rules_.tolerance, rules_.length)) break;
        factor = std::max(factor, kLeastDamping / rest.square) * 8;
        if (factor > kMostDamping) break;
      }
    }
    return rest.within(rules_.tolerance, rules_.length);
  }

 private:
  Rest measure(const JointVector& q) const {
    Rest rest;
    forward_kinematics(robot_, q, rest.chain);
    rest.residual = goal_.residual(rest.chain);
    rest.residual.template head<3>() /= rules_.length;
    rest.square = rest.residual.squaredNorm();
    return rest;
  }

  /// Joints at a bound that the step would push outwards are held, the others make up for them.
  JointVector limited_step(const Rest& rest, double damping, const JointVector& q) const {
    Jacobian jacobian = goal_.jacobian(rest.chain);
    jacobian.topRows<3>() /= rules_.length;
    JointVector step;
    for (bool held = true; held;) {
      step = damped_step(jacobian, rest.residual, damping);
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
  const Goal& goal_;
  const DescentRules& rules_;
};

}  // namespace

bool descend_to_pose(const Robot& robot, const Pose& pose, const DescentRules& rules,
                     JointVector& q) {
  return Descent<PoseGoal>(robot, PoseGoal(robot, pose), rules).run(q);
}

bool polish_in_cell(const Robot& robot, const DeviationCell& cell, const DescentRules& rules,
                    JointVector& q) {
  if (!Descent<CellGoal>(robot, CellGoal(robot, cell), rules).run(q)) return false;
  const Vector6 outside = cell.outside(cell.measure(tcp_pose(robot, q)));
  return outside.cwiseAbs().maxCoeff() <= rules.tolerance;
}

}  // namespace wristwise
