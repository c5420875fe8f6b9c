#include "kinematics/chain_rank.hpp"

#include <Eigen/SVD>
#include <algorithm>

#include "wristwise/kinematics.hpp"

namespace wristwise {
namespace {

constexpr double kSingular = 1e-6;
constexpr int kSamples = 8;

}  // namespace

int rank_of(const Jacobian& rows) {
  Eigen::JacobiSVD<Eigen::MatrixXd> svd{Eigen::MatrixXd(rows)};
  svd.setThreshold(kSingular);
  return static_cast<int>(svd.rank());
}

int chain_rank(const Robot& robot) {
  int rank = 0;
  for (int i = 0; i < kSamples; ++i) {
    ChainPose chain;
    forward_kinematics(robot, JointVector::LinSpaced(robot.joint_count(), 0.3 + i, 1.1 + 2 * i),
                       chain);
    rank = std::max(rank, rank_of(geometric_jacobian(robot, chain)));
  }
  return rank;
}

}  // namespace wristwise
