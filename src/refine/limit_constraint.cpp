#include "refine/limit_constraint.hpp"

namespace wristwise {

namespace {

constexpr double kPositionMargin = 1e-6;  // rad or m
constexpr double kRateMargin = 1e-3;      // of the limit

double magnitude_limit(const Joint& joint, int derivative) {
  switch (derivative) {
    case 1:
      return joint.max_velocity;
    case 2:
      return joint.max_acceleration;
    default:
      return joint.max_jerk;
  }
}

void add_joint(LimitConstraint& constraint, int j, double scale, double lower, double upper) {
  constraint.joints.push_back(j);
  constraint.scale.push_back(scale);
  constraint.rows.push_back({lower, upper, 0});
}

}  // namespace

double LimitConstraint::value(const Eigen::MatrixXd& control, std::size_t k) const {
  double sum = 0;
  for (std::size_t m = 0; m < weights.size(); ++m) {
    sum += weights[m] * control(joints[k], first + static_cast<int>(m));
  }
  return scale[k] * sum;
}

std::vector<LimitConstraint> limit_constraints(const Robot& robot, const SplineBasis& basis) {
  std::vector<LimitConstraint> constraints;
  for (int derivative = 0; derivative <= 3; ++derivative) {
    for (int i = 0; i + derivative < basis.control_count(); ++i) {
      LimitConstraint constraint;
      constraint.derivative = derivative;
      constraint.first = i;
      constraint.weights = basis.derivative_weights(derivative, i);
      for (int j = 0; j < robot.joint_count(); ++j) {
        const Joint& joint = robot.joints()[static_cast<std::size_t>(j)];
        if (derivative == 0) {
          const double margin = std::min(kPositionMargin, 0.25 * (joint.upper - joint.lower));
          if (std::isfinite(joint.lower) || std::isfinite(joint.upper)) {
            add_joint(constraint, j, 1, joint.lower + margin, joint.upper - margin);
          }
        } else if (std::isfinite(magnitude_limit(joint, derivative))) {
          add_joint(constraint, j, 1 / magnitude_limit(joint, derivative), kRateMargin - 1,
                    1 - kRateMargin);
        }
      }
      if (!constraint.rows.empty()) constraints.push_back(std::move(constraint));
    }
  }
  return constraints;
}

}  // namespace wristwise
