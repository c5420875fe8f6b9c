#include "wristwise/inverse_kinematics.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "inverse_kinematics_oracle.hpp"
#include "kuka_kr5_arc.hpp"
#include "ortho_parallel.hpp"
#include "random_arm.hpp"
#include "wristwise/kinematics.hpp"

namespace wristwise {
namespace {

using test::angle_distance;
using test::contains;
using test::Dice;
using test::expect_valid;
using test::kPoseTolerance;
using test::numeric_solutions;
using test::ortho_parallel;
using test::pose_error;
using test::random_arm;
using test::solver_of;

constexpr double kPi = 3.14159265358979323846;
Pose seam_pose(double y, double spin) {
  Pose pose = Pose::Identity();
  pose.linear() << -1, 0, 0, 0, 1, 0, 0, 0, -1;
  pose.linear() = pose.linear() * Eigen::AngleAxisd(spin, Eigen::Vector3d::UnitZ());
  pose.translation() << 0.9, y, 0.3;
  return pose;
}

TEST(SphericalWristIk, CountsThePosturesOfKnownAnswer1) {
  const auto robot = test::kr5::load();
  const auto solver = solver_of(robot);
  std::vector<JointVector> branches, postures;
  int principal = 0, all = 0;
  for (int i = 0; i < 30; ++i) {
    for (int k = 0; k < 360; ++k) {
      solver->solve(seam_pose(-0.25 + 0.5 * i / 29, (k - 180) * kPi / 180), branches);
      for (const JointVector& branch : branches) {
        postures.clear();
        principal += append_turns(*robot, branch, Turns::principal, postures);
        all += append_turns(*robot, branch, Turns::all, postures);
      }
    }
  }
  EXPECT_EQ(principal, 21600);
  EXPECT_EQ(all, 82786);
}

TEST(SphericalWristIk, ReproducesRandomPosesOfTheKuka) {
  const auto robot = test::kr5::load();
  const auto solver = solver_of(robot);
  Dice dice(1);
  std::vector<JointVector> branches;
  for (int trial = 0; trial < 2000; ++trial) {
    const JointVector q = dice.posture();
    const Pose tcp = tcp_pose(*robot, q);
    solver->solve(tcp, branches);
    expect_valid(*robot, tcp, branches);
    EXPECT_TRUE(contains(branches, q, 1e-7)) << q.transpose();
  }
}

TEST(SphericalWristIk, FindsTheSolutionsOfThePublishedClosedForm) {
  const auto robot = test::kr5::load();
  const auto solver = solver_of(robot);
  Dice dice(2);
  std::vector<JointVector> branches;
  std::size_t total = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const JointVector q = dice.posture();
    const Pose flange(test::kr5::tool0(q));
    const std::vector<JointVector> published = ortho_parallel(flange);
    solver->solve(Pose(test::kr5::torch_tip(q, 0.3)), branches);
    ASSERT_EQ(branches.size(), published.size());
    for (const JointVector& solution : published) {
      EXPECT_TRUE(contains(branches, solution, 1e-6)) << solution.transpose();
    }
    total += branches.size();
  }
  EXPECT_GT(total, 4u * 2000);
}

TEST(SphericalWristIk, SolvesRandomArmsInAnyConvention) {
  Dice dice(3);
  std::vector<JointVector> branches;
  for (int arm = 0; arm < 200; ++arm) {
    const auto robot = std::make_shared<const Robot>(random_arm(dice, {arm % 2 == 0, arm % 4 < 2}));
    const auto solver = solver_of(robot);
    for (int trial = 0; trial < 20; ++trial) {
      const JointVector q = dice.posture();
      const Pose tcp = tcp_pose(*robot, q);
      solver->solve(tcp, branches);
      expect_valid(*robot, tcp, branches);
      EXPECT_TRUE(contains(branches, q, 1e-6)) << "arm " << arm << ": " << q.transpose();
    }
  }
}

TEST(SphericalWristIk, MissesNoSolutionThatAMultiStartSearchFinds) {
  Dice dice(4);
  std::vector<JointVector> branches;
  for (int arm = 0; arm < 4; ++arm) {
    const auto robot = std::make_shared<const Robot>(random_arm(dice, {arm < 2, arm % 2 == 0}));
    const Pose tcp = tcp_pose(*robot, dice.posture());
    solver_of(robot)->solve(tcp, branches);
    const std::vector<JointVector> found = numeric_solutions(*robot, tcp, dice, 150);
    EXPECT_GE(found.size(), 2u);
    EXPECT_LE(found.size(), branches.size());
    for (const JointVector& q : found) {
      EXPECT_TRUE(contains(branches, q, 1e-4)) << "arm " << arm << ": " << q.transpose();
    }
  }
}

TEST(SphericalWristIk, ReproducesPosesNextToAndAtSingularPostures) {
  const auto robot = test::kr5::load();
  const auto solver = solver_of(robot);
  const double stretched = std::atan2(0.12, 0.62);
  Dice dice(5);
  std::vector<JointVector> branches;
  for (int trial = 0; trial < 3000; ++trial) {
    const double near = trial % 10 == 0 ? 0 : dice.sign() * std::pow(10, dice.uniform(-16, -2));
    JointVector q = dice.posture();
    if (trial % 3 != 1) q[4] = near + (trial % 5 == 0 ? kPi : 0);
    if (trial % 3 != 0) q[2] = stretched + near + (trial % 4 == 0 ? kPi : 0);
    const Pose tcp = tcp_pose(*robot, q);
    solver->solve(tcp, branches);
    EXPECT_FALSE(branches.empty()) << q.transpose();
    for (const JointVector& branch : branches) {
      EXPECT_LT(pose_error(tcp_pose(*robot, branch), tcp), kPoseTolerance) << q.transpose();
    }
  }
}

TEST(SphericalWristIk, ReproducesPosesWithTheWristOnAxis1) {
  const auto robot = test::kr5::load();
  const auto solver = solver_of(robot);
  Dice dice(6);
  std::vector<JointVector> branches;
  for (int trial = 0; trial < 200; ++trial) {
    const double offset = trial % 4 == 0 ? 0 : std::pow(10, dice.uniform(-16, -3));
    Pose flange = Pose::Identity();
    flange.linear() = dice.rotation();
    flange.translation() =
        Eigen::Vector3d(offset, 0, dice.uniform(0.8, 1.4)) + 0.115 * flange.linear().col(2);
    const Pose tcp = flange * Eigen::AngleAxisd(kPi / 4, Eigen::Vector3d::UnitY()) *
                     Eigen::Translation3d(0, 0, 0.3);
    solver->solve(tcp, branches);
    EXPECT_FALSE(branches.empty());
    for (const JointVector& branch : branches) {
      EXPECT_LT(pose_error(tcp_pose(*robot, branch), tcp), kPoseTolerance);
    }
  }
}

TEST(SphericalWristIk, ChoosesJoint4AtTheSingularWrist) {
  const auto robot = test::kr5::load();
  std::vector<JointVector> branches;
  const JointVector q = (JointVector(6) << 0.3, -1.2, 1.5, 0.7, 0, -0.4).finished();
  solver_of(robot)->solve(tcp_pose(*robot, q), branches);
  const JointVector chosen = (JointVector(6) << 0.3, -1.2, 1.5, 0, 0, 0.3).finished();
  EXPECT_TRUE(contains(branches, chosen, 1e-7));
}

TEST(SphericalWristIk, AnswersNothingOutOfReachOrForNan) {
  const auto robot = test::kr5::load();
  const auto solver = solver_of(robot);
  std::vector<JointVector> branches(3);
  Pose far = seam_pose(0, 0);
  far.translation().x() = 3;
  solver->solve(far, branches);
  EXPECT_TRUE(branches.empty());
  far.translation().x() = NAN;
  solver->solve(far, branches);
  EXPECT_TRUE(branches.empty());
}

TEST(SphericalWristIk, KeepsTheOrderOfBranchesAlongAPath) {
  const auto robot = test::kr5::load();
  const auto solver = solver_of(robot);
  std::vector<JointVector> before, now;
  for (int i = 0; i <= 500; ++i) {
    solver->solve(seam_pose(-0.25 + 0.001 * i, 0.8), now);
    ASSERT_EQ(now.size(), 8u);
    for (std::size_t k = 0; i > 0 && k < 8; ++k) {
      EXPECT_LT(angle_distance(before[k], now[k]), 0.05) << "branch " << k << " at " << i;
    }
    before = now;
  }
}

/// A posture with some joints on a multiple of 90 deg, or next to one: where angles are zero, at
/// the ends of their range, and directions fall on an axis.
JointVector awkward_posture(Dice& dice) {
  JointVector q = dice.posture();
  for (double& angle : q) {
    const double kind = dice.uniform(0, 1);
    if (kind > 0.6) continue;
    angle = std::floor(dice.uniform(-1, 3)) * kPi / 2;
    if (kind < 0.2) angle += dice.sign() * std::pow(10, dice.uniform(-17, -3));
  }
  return q;
}

TEST(SphericalWristIk, ReproducesPosturesOnMultiplesOfARightAngle) {
  Dice dice(10);
  std::vector<JointVector> branches;
  for (int arm = 0; arm < 60; ++arm) {
    const auto robot =
        arm == 0 ? test::kr5::load()
                 : std::make_shared<const Robot>(random_arm(dice, {arm % 2 == 0, arm % 4 < 2}));
    const auto solver = solver_of(robot);
    for (int trial = 0; trial < 300; ++trial) {
      const JointVector q = awkward_posture(dice);
      const Pose tcp = tcp_pose(*robot, q);
      solver->solve(tcp, branches);
      EXPECT_FALSE(branches.empty()) << q.transpose();
      for (const JointVector& branch : branches) {
        EXPECT_LT(pose_error(tcp_pose(*robot, branch), tcp), kPoseTolerance) << q.transpose();
        EXPECT_GT(branch.minCoeff(), -kPi);
        EXPECT_LE(branch.maxCoeff(), kPi);
      }
      if (arm == 0 && std::abs(std::sin(q[4])) > 1e-3) {
        EXPECT_TRUE(contains(branches, q, 1e-6)) << "arm " << arm << ": " << q.transpose();
      }
    }
  }
}

TEST(SphericalWristIk, SolvesAWristNextToRightAnglesLikeOneWithRightAngles) {
  Dice dice(11);
  std::vector<JointVector> branches;
  for (int arm = 0; arm < 60; ++arm) {
    const Robot right_angled = random_arm(dice, {true, true});
    Robot::Parts parts;
    parts.name = "next to right angles";
    parts.joints = right_angled.joints();
    parts.tcp = right_angled.tcp();
    const double off = std::pow(10, dice.uniform(-16, -10));
    parts.joints[4].axis = (parts.joints[4].axis + off * dice.rotation().col(0)).normalized();
    const auto robot = std::make_shared<const Robot>(parts);
    const auto solver = solver_of(robot);
    for (int trial = 0; trial < 50; ++trial) {
      const JointVector q = dice.posture();
      const Pose tcp = tcp_pose(*robot, q);
      solver->solve(tcp, branches);
      expect_valid(*robot, tcp, branches);
      if (std::abs(std::sin(q[4])) < 0.01) continue;
      EXPECT_TRUE(contains(branches, q, 1e-6)) << "off by " << off << ": " << q.transpose();
      EXPECT_EQ(branches.size() % 2, 0u);
    }
  }
}

TEST(SphericalWristIk, GivesTheTwoWristsOfAnArmOneAfterTheOther) {
  const auto robot = test::kr5::load();
  const auto solver = solver_of(robot);
  Dice dice(12);
  std::vector<JointVector> branches;
  for (int trial = 0; trial < 500; ++trial) {
    solver->solve(tcp_pose(*robot, dice.posture()), branches);
    ASSERT_EQ(branches.size() % 2, 0u);
    for (std::size_t i = 0; i < branches.size(); i += 2) {
      EXPECT_EQ(branches[i].head<3>(), branches[i + 1].head<3>());
      EXPECT_GT(branches[i][4], 0);
      JointVector flipped = branches[i];
      flipped[3] += kPi;
      flipped[4] *= -1;
      flipped[5] += kPi;
      EXPECT_LT(angle_distance(flipped, branches[i + 1]), 1e-13);
    }
  }
}

/// The KUKA with errors in every joint origin, as a calibration finds them.
Robot miscalibrated(Dice& dice, double size) {
  const auto ideal = test::kr5::load();
  Robot::Parts parts;
  parts.name = "calibrated";
  parts.joints = ideal->joints();
  parts.tcp = ideal->tcp();
  for (Joint& joint : parts.joints) {
    joint.origin.translation() += dice.vector(size);
    joint.origin.linear() = joint.origin.linear() *
                            Eigen::AngleAxisd(dice.uniform(-size, size), dice.rotation().col(0));
  }
  return Robot(parts);
}

TEST(CalibratedArmIk, FindsRandomPosturesOfTheTrueChain) {
  Dice dice(7);
  std::vector<JointVector> branches;
  for (const double size : {1e-4, 1e-5, 1e-8}) {
    for (int arm = 0; arm < 5; ++arm) {
      const auto robot = std::make_shared<const Robot>(miscalibrated(dice, size));
      const auto solver = solver_of(robot);
      for (int trial = 0; trial < 100; ++trial) {
        JointVector q = dice.posture();
        if (std::abs(std::sin(q[4])) < 0.05) q[4] = 1;
        const Pose tcp = tcp_pose(*robot, q);
        solver->solve(tcp, branches);
        expect_valid(*robot, tcp, branches);
        EXPECT_TRUE(contains(branches, q, 1e-6)) << q.transpose();
      }
    }
  }
}

TEST(CalibratedArmIk, ReproducesPosesNextToTheWristSingularity) {
  Dice dice(8);
  std::vector<JointVector> branches;
  int unsolved = 0, trials = 0;
  for (int arm = 0; arm < 5; ++arm) {
    const auto robot = std::make_shared<const Robot>(miscalibrated(dice, 1e-4));
    const auto solver = solver_of(robot);
    for (int trial = 0; trial < 100; ++trial) {
      JointVector q = dice.posture();
      q[4] = trial % 4 == 0 ? 0 : dice.sign() * std::pow(10, dice.uniform(-6, -2));
      const Pose tcp = tcp_pose(*robot, q);
      solver->solve(tcp, branches);
      expect_valid(*robot, tcp, branches);
      unsolved += branches.empty() ? 1 : 0;
      ++trials;
    }
  }
  EXPECT_LE(unsolved, trials / 500) << "of " << trials;
}

}  // namespace
}  // namespace wristwise
