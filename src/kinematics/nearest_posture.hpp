#pragma once

#include <vector>

#include "kinematics/deviation_cell.hpp"

namespace wristwise {

/// The posture nearest to another one whose TCP is in a cell, as a nonlinear programme (F73):
///   min |q - start|^2 / 2  with  B (e(q) - e_lo) = 0  for the coordinates without width, B a basis
///   of what the chain can move of them,  and  e - e_up <= 0, e_lo - e <= 0  for the bounded ones.
class NearestPosture {
 public:
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  NearestPosture(const Robot& robot, const DeviationCell& cell, JointVector start);

  Eigen::Index equality_count() const { return basis_.rows(); }
  Eigen::Index inequality_count() const { return static_cast<Eigen::Index>(2 * bounded_.size()); }

  double objective(const JointVector& q) const { return (q - start_).squaredNorm() / 2; }
  JointVector objective_gradient(const JointVector& q) const { return q - start_; }

  /// Values, and their derivatives by the joints.
  void equalities(const JointVector& q, Eigen::Ref<Eigen::VectorXd> values, Rows& jacobian) const;
  void inequalities(const JointVector& q, Eigen::Ref<Eigen::VectorXd> values, Rows& jacobian) const;

 private:
  Eigen::MatrixXd movable(const std::vector<int>& fixed) const;

  const Robot& robot_;
  const DeviationCell& cell_;
  JointVector start_;
  std::vector<int> bounded_;
  Eigen::MatrixXd basis_;  // rows: the equalities; columns: the coordinates
};

}  // namespace wristwise
