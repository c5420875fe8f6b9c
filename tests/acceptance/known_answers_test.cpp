// The two known answers: optima that independent solvers agree on.

#include <gtest/gtest.h>

#include <cmath>

#include "wristwise/wristwise.hpp"

namespace wristwise {
namespace {

const std::string kSource = WRISTWISE_SOURCE_DIR;

std::vector<std::string> joint_names(const Robot& robot) {
  const std::vector<std::string> names = robot.joint_names();
  return names;
}

class KnownGraph : public testing::TestWithParam<Turns> {};

TEST_P(KnownGraph, HasItsLeastCost) {
  Problem problem = load_problem(kSource + "/problems/known_graph.yaml");
  problem.graph.turns = GetParam();
  const PlanResult result = plan_graph_only(problem);
  const bool all = GetParam() == Turns::all;
  EXPECT_EQ(result.status, Status::solved);
  EXPECT_EQ(result.graph.vertices, all ? 82786U : 21600U);
  if (!all) {
    EXPECT_EQ(result.graph.edges, 15033600);
  }
  EXPECT_NEAR(result.graph.cost, 0.858493816637, 1e-9);
  double l1 = 0;
  for (std::size_t i = 0; i + 1 < result.path.size(); ++i) {
    l1 += (result.path.positions[i + 1] - result.path.positions[i]).cwiseAbs().sum();
  }
  EXPECT_NEAR(l1, 0.858493816637, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Turns, KnownGraph, testing::Values(Turns::all, Turns::principal));

/// J over s = t / T in [0, 1], from differences of the waypoints: nothing of the optimiser's.
double cost_of_differences(const JointPath& path) {
  const auto count = static_cast<Eigen::Index>(path.size());
  Eigen::MatrixXd q(6, count);
  for (Eigen::Index i = 0; i < count; ++i) q.col(i) = path.positions[static_cast<std::size_t>(i)];
  const double h = 1.0 / static_cast<double>(count - 1), lambda = 0.05;
  const auto differences = [](const Eigen::MatrixXd& m) {
    return (m.rightCols(m.cols() - 1) - m.leftCols(m.cols() - 1)).eval();
  };
  const Eigen::MatrixXd first = differences(q), second = differences(first),
                        third = differences(second);
  return first.squaredNorm() / h + std::pow(lambda, 2) * second.squaredNorm() / std::pow(h, 3) +
         std::pow(lambda, 4) * third.squaredNorm() / std::pow(h, 5);
}

/// The distance of the torch, a capsule of radius 0.02 m, from the ball, in closed form.
double torch_to_ball(const Robot& robot, const JointVector& q) {
  const Pose tcp = tcp_pose(robot, q);
  const Eigen::Vector3d ball(0.895654462064, 0.1, 0.423565462757), tip = tcp.translation();
  const Eigen::Vector3d along = -0.3 * tcp.linear().col(2);
  const double share = std::clamp((ball - tip).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (ball - tip - share * along).norm() - 0.05 - 0.02;
}

class KnownTrajectory : public testing::TestWithParam<int> {};

TEST_P(KnownTrajectory, IsFound) {
  const Problem problem = load_problem(kSource + "/problems/known_trajectory.yaml");
  const std::string seed =
      kSource + "/tests/acceptance/wrist_singularity/seed_" + std::to_string(GetParam()) + ".csv";
  const JointPath path = read_trajectory(seed, joint_names(*problem.robot)).path;
  ASSERT_EQ(path.size(), static_cast<std::size_t>(GetParam()));
  EXPECT_GT(cost_of_differences(path), 400);

  const PlanResult result = smooth(problem, path);
  EXPECT_EQ(result.status, Status::solved);
  EXPECT_LE(50 * result.refine.objective, 0.3216);
  EXPECT_LE(cost_of_differences(result.path), 0.3216);
  EXPECT_GE(50 * result.refine.objective, 0.3197);  // below the optimum something would be violated

  for (std::size_t i = 0; i < result.path.size(); ++i) {
    const JointVector& q = result.path.positions[i];
    const Pose tcp = tcp_pose(*problem.robot, q);
    const Eigen::Vector3d nominal(0.820654462064, -0.25 + 0.01 * path.times[i], 0.273565462757);
    EXPECT_LT((tcp.translation() - nominal).cwiseAbs().maxCoeff(), 1e-6);
    // Torch straight down: R_p = Ry(pi), and R_p^T R = Rx(a) Ry(b) Rz(c) has the third column
    // (sin b, -sin a cos b, cos a cos b).
    const Eigen::Vector3d z = Eigen::Vector3d(-1, 1, -1).cwiseProduct(tcp.linear().col(2));
    const double limit = 10 * M_PI / 180 + 1e-6;
    EXPECT_LE(std::abs(std::asin(z.x())), limit);
    EXPECT_LE(std::abs(std::atan2(-z.y(), z.z())), limit);
    EXPECT_GE(torch_to_ball(*problem.robot, q), 0.02 - 1e-6);
  }
  for (double t = 0; t <= 50; t += 0.01) {
    const JointVector q = result.trajectory.evaluate(t);
    EXPECT_GE(torch_to_ball(*problem.robot, q), 0.02 - 1e-6);
    EXPECT_LE(std::abs(result.trajectory.evaluate(t, 1)[3]), 0.0035);
    EXPECT_LE(std::abs(result.trajectory.evaluate(t, 1)[5]), 0.0035);
  }
}

INSTANTIATE_TEST_SUITE_P(Waypoints, KnownTrajectory, testing::Values(50, 200, 400));

}  // namespace
}  // namespace wristwise
