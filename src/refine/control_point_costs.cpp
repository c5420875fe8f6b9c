#include "refine/control_point_costs.hpp"

#include <cmath>

namespace wristwise {

namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using JacobianBlock = Eigen::Map<RowMajor>;

/// A residual of consecutive control points, each a parameter block of one value per joint.
class ControlPointCost : public ceres::CostFunction {
 public:
  ControlPointCost(int joints, int blocks, int residuals) : joints_(joints) {
    set_num_residuals(residuals);
    mutable_parameter_block_sizes()->assign(static_cast<std::size_t>(blocks), joints);
  }

 protected:
  int joints() const { return joints_; }
  int blocks() const { return static_cast<int>(parameter_block_sizes().size()); }
  JacobianBlock jacobian(double** jacobians, int block) const {
    return {jacobians[block], num_residuals(), joints_};
  }
  Eigen::Map<const Eigen::VectorXd> control(double const* const* parameters, int block) const {
    return {parameters[block], joints_};
  }
  /// q = sum_k N_k c_k.
  JointVector posture(double const* const* parameters, const SplineBasis::Values& basis) const {
    JointVector q = JointVector::Zero(joints_);
    for (int k = 0; k < blocks(); ++k) q += basis.derivatives(k, 0) * control(parameters, k);
    return q;
  }
  /// d r / d c_k = N_k d r / d q.
  void chain_rule(const Eigen::MatrixXd& d_q, const SplineBasis::Values& basis,
                  double** jacobians) const {
    for (int k = 0; k < blocks(); ++k) {
      if (jacobians[k] != nullptr) jacobian(jacobians, k) = basis.derivatives(k, 0) * d_q;
    }
  }

 private:
  int joints_;
};

class ObjectiveCost final : public ControlPointCost {
 public:
  ObjectiveCost(const ObjectiveRow& row, const ObjectiveWeights& weights)
      : ControlPointCost(static_cast<int>(weights.joint.size()), SplineBasis::kLocal,
                         static_cast<int>(weights.joint.size())),
        row_(row),
        weights_(weights) {}

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override {
    Eigen::Map<Eigen::VectorXd> residual(residuals, joints());
    residual.setZero();
    for (int k = 0; k < SplineBasis::kLocal; ++k) {
      residual += row_.coefficients[k] * (control(parameters, k) - weights_.posture);
    }
    residual.array() *= weights_.joint.array();
    for (int k = 0; jacobians != nullptr && k < SplineBasis::kLocal; ++k) {
      if (jacobians[k] == nullptr) continue;
      JacobianBlock block = jacobian(jacobians, k);
      block.setZero();
      block.diagonal() = row_.coefficients[k] * weights_.joint;
    }
    return true;
  }

 private:
  const ObjectiveRow& row_;
  const ObjectiveWeights& weights_;
};

class SingularityCost final : public ControlPointCost {
 public:
  SingularityCost(const Robot& robot, const PosturePoint& point)
      : ControlPointCost(robot.joint_count(), SplineBasis::kLocal, 1),
        robot_(robot),
        point_(point) {}

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override {
    ChainPose chain;
    forward_kinematics(robot_, posture(parameters, point_.basis), chain);
    JointVector slope;
    const double c = wrist_alignment(robot_, chain, &slope);
    residuals[0] = point_.sqrt_weight * std::pow(c, 4);
    if (jacobians == nullptr) return true;
    chain_rule(4 * point_.sqrt_weight * std::pow(c, 3) * slope.transpose(), point_.basis,
               jacobians);
    return true;
  }

 private:
  const Robot& robot_;
  const PosturePoint& point_;
};

class OwnCost final : public ControlPointCost {
 public:
  OwnCost(const ObjectiveWeights& weights, const PosturePoint& point)
      : ControlPointCost(static_cast<int>(weights.joint.size()), SplineBasis::kLocal,
                         static_cast<int>(weights.own.size())),
        own_(weights.own),
        point_(point) {}

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override {
    const JointVector q = posture(parameters, point_.basis);
    Eigen::MatrixXd d_q(num_residuals(), joints());
    for (int r = 0; r < num_residuals(); ++r) {
      JointVector slope = JointVector::Zero(joints());
      residuals[r] =
          point_.sqrt_weight * own_residual(own_[static_cast<std::size_t>(r)], point_.time, q,
                                            jacobians == nullptr ? nullptr : &slope);
      d_q.row(r) = point_.sqrt_weight * slope.transpose();
    }
    if (jacobians != nullptr) chain_rule(d_q, point_.basis, jacobians);
    return true;
  }

 private:
  const std::vector<PostureResidual>& own_;
  const PosturePoint& point_;
};

class DeviationCost final : public ControlPointCost {
 public:
  DeviationCost(const Robot& robot, const DeviationPoint& point)
      : ControlPointCost(robot.joint_count(), SplineBasis::kLocal, 6),
        robot_(robot),
        point_(point) {}

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override {
    ChainPose chain;
    forward_kinematics(robot_, posture(parameters, point_.basis), chain);
    const Vector6 e = deviation(point_.tolerance, point_.frame, chain.tcp);
    Eigen::Map<Vector6> residual(residuals);
    residual = point_.sqrt_weights.cwiseProduct(e);
    if (jacobians == nullptr) return true;
    const Jacobian d_e = deviation_jacobian(point_.tolerance, point_.frame, chain.tcp,
                                            geometric_jacobian(robot_, chain));
    const Eigen::MatrixXd d_q = point_.sqrt_weights.asDiagonal() * d_e;
    chain_rule(d_q, point_.basis, jacobians);
    return true;
  }

 private:
  const Robot& robot_;
  const DeviationPoint& point_;
};

class PointCost final : public ControlPointCost {
 public:
  PointCost(const Robot& robot, ClearanceChecker& checker, const PointConstraint& point, double mu)
      : ControlPointCost(robot.joint_count(), SplineBasis::kLocal,
                         static_cast<int>(point.rows.size())),
        checker_(checker),
        point_(point),
        mu_(mu * point.weight) {}

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override {
    evaluate(point_, checker_, posture(parameters, point_.basis), mu_, jacobians != nullptr,
             values_);
    for (Eigen::Index r = 0; r < values_.c.size(); ++r) {
      double slope = 0;
      residuals[r] =
          point_.rows[static_cast<std::size_t>(r)].bounds.residual(values_.c[r], mu_, slope);
      if (jacobians != nullptr) values_.jacobian.row(r) *= slope;
    }
    if (jacobians != nullptr) chain_rule(values_.jacobian, point_.basis, jacobians);
    return true;
  }

 private:
  ClearanceChecker& checker_;
  const PointConstraint& point_;
  double mu_;
  mutable PointValues values_;  ///< a buffer: Ceres runs on one thread here
};

class LimitCost final : public ControlPointCost {
 public:
  LimitCost(const LimitConstraint& limit, int joints, double mu)
      : ControlPointCost(joints, static_cast<int>(limit.weights.size()),
                         static_cast<int>(limit.rows.size())),
        limit_(limit),
        mu_(mu) {}

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override {
    for (int k = 0; jacobians != nullptr && k < blocks(); ++k) {
      if (jacobians[k] != nullptr) jacobian(jacobians, k).setZero();
    }
    for (std::size_t r = 0; r < limit_.rows.size(); ++r) {
      double value = 0, slope = 0;
      for (int k = 0; k < blocks(); ++k) {
        value += limit_.weights[static_cast<std::size_t>(k)] * parameters[k][limit_.joints[r]];
      }
      residuals[r] = limit_.rows[r].residual(limit_.scale[r] * value, mu_, slope);
      for (int k = 0; jacobians != nullptr && k < blocks(); ++k) {
        if (jacobians[k] == nullptr) continue;
        jacobian(jacobians, k)(static_cast<Eigen::Index>(r), limit_.joints[r]) =
            slope * limit_.scale[r] * limit_.weights[static_cast<std::size_t>(k)];
      }
    }
    return true;
  }

 private:
  const LimitConstraint& limit_;
  double mu_;
};

}  // namespace

ceres::CostFunction* objective_cost(const ObjectiveRow& row, const ObjectiveWeights& weights) {
  return new ObjectiveCost(row, weights);
}

ceres::CostFunction* singularity_cost(const Robot& robot, const PosturePoint& point) {
  return new SingularityCost(robot, point);
}

ceres::CostFunction* own_cost(const ObjectiveWeights& weights, const PosturePoint& point) {
  return new OwnCost(weights, point);
}

ceres::CostFunction* deviation_cost(const Robot& robot, const DeviationPoint& point) {
  return new DeviationCost(robot, point);
}

ceres::CostFunction* point_cost(const Robot& robot, ClearanceChecker& checker,
                                const PointConstraint& point, double mu) {
  return new PointCost(robot, checker, point, mu);
}

ceres::CostFunction* limit_cost(const LimitConstraint& limit, int joints, double mu) {
  return new LimitCost(limit, joints, mu);
}

}  // namespace wristwise
