// The closed form of arms whose axes 1 and 2 meet, and the seven-axis arms that it serves.

#include "kinematics/crossed_shoulder.hpp"

#include <gtest/gtest.h>

#include "inverse_kinematics_oracle.hpp"
#include "published_arms.hpp"

namespace wristwise {
namespace {

using test::Dice;

/// A random arm whose axes 1 and 2, and whose axes 4, 5 and 6, meet.
std::shared_ptr<const Robot> random_crossed_arm(Dice& dice, bool right_angled) {
  const auto next = [&](const Eigen::Vector3d& axis) -> Eigen::Vector3d {
    const Eigen::Vector3d side = axis.cross(dice.rotation().col(0)).normalized();
    return Eigen::AngleAxisd(right_angled ? Dice::kPi / 2 : dice.uniform(0.6, 2.4), side) * axis;
  };
  std::array<Eigen::Vector3d, 6> h, p;
  h[0] = dice.rotation().col(2);
  for (std::size_t j = 1; j < 6; ++j) h[j] = next(h[j - 1]);
  p[0] = p[1] = dice.vector(1);
  p[2] = p[0] + dice.vector(0.5);
  p[3] = p[4] = p[5] = p[2] + dice.vector(0.5);
  Pose tcp = Pose::Identity();
  tcp.linear() = dice.rotation();
  tcp.translation() = p[5] + dice.vector(0.4);
  return std::make_shared<const Robot>(test::arm_from_axes(p, h, tcp, dice));
}

TEST(CrossedShoulder, SolvesRandomArmsInAnyConvention) {
  Dice dice(1);
  std::vector<JointVector> branches;
  std::size_t most = 0;
  for (int arm = 0; arm < 200; ++arm) {
    const auto robot = random_crossed_arm(dice, arm % 2 == 0);
    const auto solver = CrossedShoulder::find(robot);
    ASSERT_NE(solver, nullptr);
    for (int trial = 0; trial < 20; ++trial) {
      const JointVector q = dice.posture();
      const Pose tcp = tcp_pose(*robot, q);
      solver->solve(tcp, branches);
      test::expect_valid(*robot, tcp, branches);
      EXPECT_TRUE(test::contains(branches, q, 1e-6)) << "arm " << arm << ": " << q.transpose();
      EXPECT_LE(branches.size(), 8U);
      most = std::max(most, branches.size());
    }
  }
  EXPECT_EQ(most, 8U);
}

TEST(CrossedShoulder, MissesNoSolutionThatAMultiStartSearchFinds) {
  Dice dice(2);
  std::vector<JointVector> branches;
  for (int arm = 0; arm < 6; ++arm) {
    const auto robot = random_crossed_arm(dice, arm % 2 == 0);
    const Pose tcp = tcp_pose(*robot, dice.posture());
    CrossedShoulder::find(robot)->solve(tcp, branches);
    const std::vector<JointVector> found = test::numeric_solutions(*robot, tcp, dice, 150);
    EXPECT_GE(found.size(), 2U);
    EXPECT_LE(found.size(), branches.size());
    for (const JointVector& q : found)
      EXPECT_TRUE(test::contains(branches, q, 1e-4)) << "arm " << arm << ": " << q.transpose();
  }
}

/// Joints on multiples of a right angle or next to one: stretched elbow, straight wrist, wrist
/// centre on axis 1.
TEST(CrossedShoulder, ReproducesPosesNextToAndAtSingularPostures) {
  Dice dice(3);
  std::vector<JointVector> branches;
  for (int trial = 0; trial < 2000; ++trial) {
    const auto robot = random_crossed_arm(dice, true);
    JointVector q = dice.posture();
    for (double& angle : q) {
      const double kind = dice.uniform(0, 1);
      if (kind > 0.6) continue;
      angle = std::floor(dice.uniform(-1, 3)) * Dice::kPi / 2;
      if (kind < 0.2) angle += dice.sign() * std::pow(10, dice.uniform(-17, -3));
    }
    const Pose tcp = tcp_pose(*robot, q);
    CrossedShoulder::find(robot)->solve(tcp, branches);
    EXPECT_FALSE(branches.empty()) << q.transpose();
    for (const JointVector& branch : branches)
      EXPECT_LT(test::pose_error(tcp_pose(*robot, branch), tcp), test::kPoseTolerance);
  }
}

TEST(CrossedShoulder, AnswersNothingOutOfReachOrForNan) {
  Dice dice(4);
  const auto robot = random_crossed_arm(dice, false);
  const auto solver = CrossedShoulder::find(robot);
  for (const double x : {100.0, std::nan("")}) {
    std::vector<JointVector> branches(3);
    Pose far = tcp_pose(*robot, dice.posture());
    far.translation().x() = x;
    solver->solve(far, branches);
    EXPECT_TRUE(branches.empty());
  }
}

TEST(CrossedShoulder, TakesRoundedNumbersAndRefusesOtherArms) {
  Dice dice(5);
  const auto ideal = random_crossed_arm(dice, true);
  const auto moved = [&](std::size_t joint, double by) {
    Robot::Parts parts = ideal->parts();
    parts.joints[joint].origin.translation() += by * dice.rotation().col(0);
    return std::make_shared<const Robot>(parts);
  };
  for (const std::size_t joint : {1U, 4U}) {
    const auto rounded = moved(joint, 3e-6);
    const auto solver = CrossedShoulder::find(rounded);
    ASSERT_NE(solver, nullptr);
    std::vector<JointVector> branches;
    int found = 0;
    for (int trial = 0; trial < 100; ++trial) {
      const JointVector q = dice.posture();
      const Pose tcp = tcp_pose(*rounded, q);
      solver->solve(tcp, branches);
      test::expect_valid(*rounded, tcp, branches);
      found += test::contains(branches, q, 1e-6);
    }
    EXPECT_GE(found, 99);  // next to a double root a solution may be lost
    EXPECT_EQ(CrossedShoulder::find(moved(joint, 0.01)), nullptr);
  }
  EXPECT_EQ(CrossedShoulder::find(test::offset_wrist_arm().load()), nullptr);
  EXPECT_EQ(CrossedShoulder::find(test::seven_axis_arm().load()), nullptr);
}

/// Whichever joint of its shoulder is held, the rest of the seven-axis arm has a closed form.
TEST(CrossedShoulder, ServesTheSevenAxisArm) {
  const auto robot = test::seven_axis_arm().load();
  Dice dice(6);
  std::vector<JointVector> branches;
  for (const std::string joint : {"joint_a1", "joint_a2", "joint_a3"}) {
    const InverseKinematicsFound found = find_redundant_inverse_kinematics(
        robot, {{joint, 0.5}}, {[](const auto& rest) { return find_inverse_kinematics(rest); }});
    ASSERT_NE(found.solver, nullptr) << found.description;
    EXPECT_NE(found.description.find("axes 1 and 2 meet, spherical wrist, closed form"),
              std::string::npos)
        << found.description;
    for (int trial = 0; trial < 100; ++trial) {
      JointVector q = dice.posture(7);
      q[3] = dice.uniform(0.3, 2);
      const Pose tcp = tcp_pose(*robot, q);
      found.solver->solve_beside(tcp, q, branches);
      EXPECT_TRUE(test::contains(branches, q, 1e-6)) << joint << ": " << q.transpose();
      found.solver->solve(tcp, branches);
      for (const JointVector& branch : branches)
        EXPECT_LT(test::pose_error(tcp_pose(*robot, branch), tcp), test::kPoseTolerance);
    }
  }
}

}  // namespace
}  // namespace wristwise
