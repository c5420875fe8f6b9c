#include "kinematics/singularity.hpp"

#include <gtest/gtest.h>

#include <Eigen/SVD>
#include <cmath>
#include <random>

#include "gantry.hpp"
#include "kuka_kr5_arc.hpp"

namespace wristwise {
namespace {

namespace kr5 = test::kr5;

JointVector random_posture(std::mt19937& random, const Robot& robot) {
  JointVector q(robot.joint_count());
  for (int j = 0; j < robot.joint_count(); ++j) {
    const Joint& joint = robot.joints()[static_cast<std::size_t>(j)];
    q[j] = std::uniform_real_distribution<double>(joint.lower, joint.upper)(random);
  }
  return q;
}

/// Axes 4 and 6 of the KR 5 enclose the angle of joint 5.
TEST(SingularityDistance, OfTheWristIsTheSineOfJoint5) {
  const auto robot = kr5::load();
  const SingularityDistance distance(*robot, SingularityMeasure::wrist);
  std::mt19937 random(1);
  for (int i = 0; i < 200; ++i) {
    JointVector q = random_posture(random, *robot);
    if (i % 4 == 0) q[4] = 0;
    EXPECT_NEAR(distance(q), std::abs(std::sin(q[4])), 1e-12);
  }
}

/// The product of the singular values, with a Jacobian from differences.
TEST(SingularityDistance, ByManipulabilityIsInProportionToTheSingularValues) {
  const auto robot = kr5::load();
  const SingularityDistance distance(*robot, SingularityMeasure::manipulability);
  std::mt19937 random(2);
  const auto product = [&](const JointVector& q) {
    Eigen::Matrix<double, 6, 6> jacobian;
    const double h = 1e-6;
    for (int j = 0; j < 6; ++j) {
      JointVector up = q, down = q;
      up[j] += h;
      down[j] -= h;
      const Pose a = tcp_pose(*robot, down), b = tcp_pose(*robot, up);
      jacobian.col(j).head<3>() = (b.translation() - a.translation()) / (2 * h);
      const Eigen::AngleAxisd turn(Eigen::Matrix3d(b.linear() * a.linear().transpose()));
      jacobian.col(j).tail<3>() = turn.angle() * turn.axis() / (2 * h);
    }
    return Eigen::JacobiSVD<Eigen::MatrixXd>(jacobian).singularValues().prod();
  };
  double ratio = 0;
  int compared = 0;
  for (int i = 0; i < 100; ++i) {
    const JointVector q = random_posture(random, *robot);
    const double measured = distance(q);
    EXPECT_GE(measured, 0);
    EXPECT_LE(measured, 1);
    if (measured < 0.05 || measured == 1) continue;
    if (ratio == 0) ratio = product(q) / measured;
    EXPECT_NEAR(product(q) / measured, ratio, 1e-6 * ratio);
    ++compared;
  }
  EXPECT_GT(compared, 50);
  JointVector straight = JointVector::Zero(6);
  straight[4] = 0;
  EXPECT_NEAR(distance(straight), 0, 1e-6);
}

TEST(SingularityDistance, OfAChainWithFewerThanSixJoints) {
  const auto robot = test::gantry::robot();
  const SingularityDistance distance(*robot, SingularityMeasure::manipulability);
  EXPECT_NEAR(distance(test::gantry::posture(0.3, -0.2, 0.1, 1)), 1, 1e-12);
}

}  // namespace
}  // namespace wristwise
