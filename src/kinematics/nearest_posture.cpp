#include "kinematics/nearest_posture.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <utility>

namespace wristwise {
namespace {

constexpr double kMovable = 1e-8;  // of the largest singular value
constexpr double kMargin = 1e-7;   // m and rad, kept from the sides of the cell
constexpr double kMarginShare = 0.01;

}  // namespace

NearestPosture::NearestPosture(const Robot& robot, const DeviationCell& cell, JointVector start)
    : robot_(robot), cell_(cell), start_(std::move(start)), basis_(Eigen::MatrixXd::Zero(0, 6)) {
  std::vector<int> fixed;
  for (int k = 0; k < 6; ++k) {
    if (cell.is_fixed(k)) fixed.push_back(k);
    if (!cell.is_fixed(k) && !cell.is_free(k)) bounded_.push_back(k);
  }
  if (!fixed.empty()) basis_ = movable(fixed);
}

Eigen::MatrixXd NearestPosture::movable(const std::vector<int>& fixed) const {
  Jacobian jacobian;
  cell_.measure(robot_, start_, jacobian);
  const auto count = static_cast<Eigen::Index>(fixed.size());
  Eigen::MatrixXd rows(count, jacobian.cols());
  for (Eigen::Index i = 0; i < count; ++i)
    rows.row(i) = jacobian.row(fixed[static_cast<std::size_t>(i)]);
  Eigen::JacobiSVD<Eigen::MatrixXd> svd(rows, Eigen::ComputeFullU);
  svd.setThreshold(kMovable);
  Eigen::MatrixXd basis = Eigen::MatrixXd::Zero(svd.rank(), 6);
  for (Eigen::Index i = 0; i < count; ++i) {
    basis.col(fixed[static_cast<std::size_t>(i)]) =
        svd.matrixU().row(i).head(svd.rank()).transpose();
  }
  return basis;
}

void NearestPosture::equalities(const JointVector& q, Eigen::Ref<Eigen::VectorXd> values,
                                Rows& jacobian) const {
  Jacobian by_joints;
  const Vector6 e = cell_.measure(robot_, q, by_joints);
  values = basis_ * cell_.outside(e);
  jacobian = basis_ * by_joints;
}

void NearestPosture::inequalities(const JointVector& q, Eigen::Ref<Eigen::VectorXd> values,
                                  Rows& jacobian) const {
  Jacobian by_joints;
  const Vector6 e = cell_.measure(robot_, q, by_joints);
  jacobian.resize(inequality_count(), q.size());
  Eigen::Index row = 0;
  for (const int k : bounded_) {
    const double margin = std::min(kMargin, kMarginShare * (cell_.upper[k] - cell_.lower[k]));
    values[row] = e[k] - cell_.upper[k] + margin;
    jacobian.row(row++) = by_joints.row(k);
    values[row] = cell_.lower[k] - e[k] + margin;
    jacobian.row(row++) = -by_joints.row(k);
  }
}

}  // namespace wristwise
