#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "random_arm.hpp"
#include "wristwise/inverse_kinematics.hpp"

namespace wristwise {
namespace {

using test::Dice;

constexpr double kPi = 3.14159265358979323846;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Robot turning_robot() {
  Robot::Parts parts;
  parts.name = "turns";
  Joint joint;
  joint.max_velocity = joint.max_acceleration = joint.max_jerk = 1;
  joint.name = "wide";
  joint.lower = -350 * kPi / 180;
  joint.upper = 350 * kPi / 180;
  parts.joints.push_back(joint);
  joint.name = "slide";
  joint.type = JointType::prismatic;
  joint.lower = 0;
  joint.upper = 20;
  parts.joints.push_back(joint);
  joint.name = "endless";
  joint.type = JointType::continuous;
  joint.lower = -kInfinity;
  joint.upper = kInfinity;
  parts.joints.push_back(joint);
  return Robot(parts);
}

TEST(AppendTurns, GivesEveryCopyInsideTheLimits) {
  const Robot robot = turning_robot();
  Dice dice(9);
  for (int trial = 0; trial < 500; ++trial) {
    JointVector branch(3);
    branch << dice.uniform(-20, 20), dice.uniform(0, 20), dice.uniform(-20, 20);
    std::vector<JointVector> postures(1);
    int limiting = 7;
    const int count = append_turns(robot, branch, Turns::all, postures, &limiting);
    std::vector<double> expected;
    for (int k = -10; k <= 10; ++k) {
      const double copy = branch[0] + 2 * kPi * k;
      if (std::abs(copy) <= 350 * kPi / 180) expected.push_back(copy);
    }
    EXPECT_EQ(limiting, -1);
    ASSERT_EQ(postures.size(), 1u + expected.size());
    EXPECT_EQ(count, static_cast<int>(expected.size()));
    for (std::size_t k = 0; k < expected.size(); ++k) {
      EXPECT_NEAR(postures[k + 1][0], expected[k], 1e-13);
      EXPECT_EQ(postures[k + 1][1], branch[1]);
      EXPECT_NEAR(std::remainder(postures[k + 1][2] - branch[2], 2 * kPi), 0, 1e-13);
      EXPECT_LE(std::abs(postures[k + 1][2]), kPi);
    }
  }
}

TEST(AppendTurns, PrincipalIsTheOneBetweenMinusPiAndPi) {
  const Robot robot = turning_robot();
  std::vector<JointVector> postures;
  const JointVector branch = (JointVector(3) << 4, 1, -4).finished();
  ASSERT_EQ(append_turns(robot, branch, Turns::principal, postures), 1);
  EXPECT_NEAR(postures[0][0], 4 - 2 * kPi, 1e-15);
  EXPECT_NEAR(postures[0][2], 2 * kPi - 4, 1e-15);
}

TEST(AppendTurns, NamesTheFirstJointOutsideItsLimits) {
  const Robot robot = turning_robot();
  std::vector<JointVector> postures;
  int limiting = -1;
  EXPECT_EQ(
      append_turns(robot, (JointVector(3) << 0, -1, 0).finished(), Turns::all, postures, &limiting),
      0);
  EXPECT_EQ(limiting, 1);
  EXPECT_EQ(append_turns(robot, (JointVector(3) << NAN, 1, 0).finished(), Turns::all, postures,
                         &limiting),
            0);
  EXPECT_EQ(limiting, 0);
  EXPECT_TRUE(postures.empty());
}

TEST(AppendTurns, KeepsAValueOnTheLimit) {
  const Robot robot = turning_robot();
  std::vector<JointVector> postures;
  const double limit = 350 * kPi / 180;
  const auto count = [&](double value) {
    postures.clear();
    return append_turns(robot, (JointVector(3) << value, 1, 0).finished(), Turns::all, postures);
  };
  EXPECT_EQ(count(limit + 1e-13), 2);
  EXPECT_EQ(count(limit + 1e-11), 1);
  EXPECT_EQ(count(-limit - 1e-13), 2);
}

TEST(AppendTurns, GivesEveryCopyOfTwoJointsTheSecondFastest) {
  Dice dice(10);
  for (int trial = 0; trial < 3000; ++trial) {
    const double widest = trial % 3 == 0 ? 4 : trial % 3 == 1 ? 8 : 40;  // rad
    Robot::Parts parts;
    parts.name = "two joints";
    for (int j = 0; j < 2; ++j) {
      Joint joint;
      joint.name = "j" + std::to_string(j);
      joint.max_velocity = joint.max_acceleration = joint.max_jerk = 1;
      joint.lower = dice.uniform(-widest, widest);
      joint.upper = joint.lower + dice.uniform(0, widest);
      parts.joints.push_back(joint);
    }
    const Robot robot(parts);
    JointVector branch(2);
    for (double& angle : branch) angle = dice.uniform(-kPi, kPi) * (trial % 2 == 0 ? 1 : 5);
    const auto copies_of = [&](int j) {
      const Joint& joint = robot.joints()[static_cast<std::size_t>(j)];
      std::vector<double> copies;
      for (int k = -30; k <= 30; ++k) {
        const double copy = branch[j] + 2 * kPi * k;
        if (copy >= joint.lower && copy <= joint.upper) copies.push_back(copy);
      }
      return copies;
    };
    const std::vector<double> first = copies_of(0), second = copies_of(1);
    std::vector<JointVector> postures;
    int limiting = 7;
    const int count = append_turns(robot, branch, Turns::all, postures, &limiting);
    EXPECT_EQ(limiting, first.empty() ? 0 : second.empty() ? 1 : -1);
    ASSERT_EQ(postures.size(), first.size() * second.size());
    EXPECT_EQ(count, static_cast<int>(postures.size()));
    for (std::size_t k = 0; k < postures.size(); ++k) {
      EXPECT_NEAR(postures[k][0], first[k / second.size()], 1e-13);
      EXPECT_NEAR(postures[k][1], second[k % second.size()], 1e-13);
    }
  }
}

}  // namespace
}  // namespace wristwise
