#include "wristwise/kinematics.hpp"

#include <gtest/gtest.h>

#include <random>

#include "kuka_kr5_arc.hpp"

namespace wristwise {
namespace {

JointVector random_posture(std::mt19937& rng, int joints, double range = 3) {
  std::uniform_real_distribution<double> value(-range, range);
  JointVector q(joints);
  for (double& angle : q) angle = value(rng);
  return q;
}

Pose random_pose(std::mt19937& rng) {
  std::normal_distribution<double> value;
  Pose pose = Pose::Identity();
  pose.linear() = Eigen::Quaterniond(value(rng), value(rng), value(rng), value(rng))
                      .normalized()
                      .toRotationMatrix();
  pose.translation() << value(rng), value(rng), value(rng);
  return pose;
}

/// A chain of joints of all types with arbitrary frames and axes.
Robot random_chain(std::mt19937& rng, int joints) {
  std::normal_distribution<double> value;
  Robot::Parts parts;
  parts.name = "random";
  for (int j = 0; j < joints; ++j) {
    Joint joint;
    joint.name = "j" + std::to_string(j);
    joint.type = j % 3 == 1 ? JointType::prismatic : JointType::revolute;
    joint.origin = random_pose(rng);
    joint.axis << value(rng), value(rng), value(rng);
    joint.lower = -10;
    joint.upper = 10;
    joint.max_velocity = joint.max_acceleration = joint.max_jerk = 1;
    parts.joints.push_back(joint);
  }
  parts.tcp = random_pose(rng);
  return Robot(parts);
}

TEST(ForwardKinematics, AgreesWithMatrixProductsOnTheKukaTable) {
  const auto robot = test::kr5::load();
  std::mt19937 rng(1);
  ChainPose chain;
  for (int trial = 0; trial < 200; ++trial) {
    const JointVector q = random_posture(rng, 6);
    forward_kinematics(*robot, q, chain);
    EXPECT_LT((chain.tcp.matrix() - test::kr5::torch_tip(q, 0.3)).norm(), 1e-14);
    EXPECT_LT((tcp_pose(*robot, q).matrix() - chain.tcp.matrix()).norm(), 1e-15);
    ASSERT_EQ(chain.joint_count, 6);
    for (int j = 0; j < 6; ++j) {
      const Eigen::Matrix4d expected = test::kr5::link_frame(q, j + 1);
      EXPECT_LT((chain.frame(j).matrix() - expected).norm(), 1e-14);
      const Eigen::Vector3d axis = expected.block<3, 1>(0, 2);
      EXPECT_LT((chain.axes[static_cast<std::size_t>(j)] - axis).norm(), 1e-14);
    }
  }
  EXPECT_TRUE(chain.frame(-1).matrix().isIdentity(0));
}

TEST(ForwardKinematics, PutsTheFlangeWhereTheMakerSaysAtZero) {
  RobotSource source = test::kr5::source();
  source.tip_link = "tool0";
  const Pose tcp = tcp_pose(load_robot(source), JointVector::Zero(6));
  EXPECT_LT((tcp.translation() - Eigen::Vector3d(1.515, 0, 0.52)).norm(), 1e-15);
  EXPECT_LT((tcp.linear().col(2) - Eigen::Vector3d::UnitX()).norm(), 1e-15);
}

/// Angular velocity times 2 h from the central difference of two rotations.
Eigen::Vector3d rotation_difference(const Pose& after, const Pose& before) {
  const Eigen::AngleAxisd turn(after.linear() * before.linear().transpose());
  return turn.angle() * turn.axis();
}

void expect_jacobians(const Robot& robot, const JointVector& q) {
  constexpr double kStep = 1e-5;
  ChainPose chain, after, before;
  forward_kinematics(robot, q, chain);
  const Jacobian geometric = geometric_jacobian(robot, chain);
  const Eigen::Vector3d local(0.3, -0.2, 0.1);
  ASSERT_EQ(geometric.cols(), q.size());
  for (int j = 0; j < q.size(); ++j) {
    JointVector shifted = q;
    shifted[j] = q[j] + kStep;
    forward_kinematics(robot, shifted, after);
    shifted[j] = q[j] - kStep;
    forward_kinematics(robot, shifted, before);
    const Eigen::Vector3d linear =
        (after.tcp.translation() - before.tcp.translation()) / (2 * kStep);
    EXPECT_LT((geometric.col(j).head<3>() - linear).norm(), 1e-8) << "joint " << j;
    const Eigen::Vector3d angular = rotation_difference(after.tcp, before.tcp) / (2 * kStep);
    EXPECT_LT((geometric.col(j).tail<3>() - angular).norm(), 1e-8) << "joint " << j;
    for (int carrier = -1; carrier < q.size(); ++carrier) {
      const PointJacobian of_point =
          point_jacobian(robot, chain, carrier, chain.frame(carrier) * local);
      ASSERT_EQ(of_point.cols(), q.size());
      const Eigen::Vector3d moved =
          (after.frame(carrier) * local - before.frame(carrier) * local) / (2 * kStep);
      EXPECT_LT((of_point.col(j) - moved).norm(), 1e-8) << "joint " << j << " on " << carrier;
    }
  }
}

TEST(Jacobians, AgreeWithCentralDifferencesOnRandomChains) {
  std::mt19937 rng(2);
  for (int joints = 1; joints <= kMaxJoints; joints += 3) {
    for (int trial = 0; trial < 5; ++trial) {
      const Robot robot = random_chain(rng, joints);
      expect_jacobians(robot, random_posture(rng, joints, 1));
    }
  }
}

TEST(Jacobians, AgreeWithCentralDifferencesAtSingularPostures) {
  const auto robot = test::kr5::load();
  JointVector q = JointVector::Zero(6);
  expect_jacobians(*robot, q);
  q << 0.3, -1.2, 1.5, 0.4, 0, -0.7;  // straight wrist
  expect_jacobians(*robot, q);
  q << 0.3, -1.2, std::atan2(0.12, 0.62), 0.4, 0.9, -0.7;  // stretched elbow
  expect_jacobians(*robot, q);
}

}  // namespace
}  // namespace wristwise
