#include "wristwise/numeric_inverse_kinematics.hpp"

#include <gtest/gtest.h>

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>

#include "dh_arms.hpp"
#include "invalid_input.hpp"
#include "parallel.hpp"
#include "random_arm.hpp"
#include "ur_closed_form.hpp"
#include "wristwise/kinematics.hpp"

namespace wristwise {
namespace {

using test::Dice;

constexpr double kPi = 3.14159265358979323846;

double pose_error(const Pose& a, const Pose& b) {
  return std::max((a.translation() - b.translation()).norm(), (a.linear() - b.linear()).norm());
}

double distance(const Robot& robot, const JointVector& a, const JointVector& b) {
  double largest = 0;
  for (int j = 0; j < robot.joint_count(); ++j) {
    const bool slides = robot.joints()[static_cast<std::size_t>(j)].type == JointType::prismatic;
    const double d = a[j] - b[j];
    largest = std::max(largest, std::abs(slides ? d : std::remainder(d, 2 * kPi)));
  }
  return largest;
}

JointVector random_posture(const Robot& robot, Dice& dice) {
  JointVector q(robot.joint_count());
  for (int j = 0; j < robot.joint_count(); ++j) {
    const Joint& joint = robot.joints()[static_cast<std::size_t>(j)];
    q[j] = dice.uniform(joint.lower, joint.upper);
  }
  return q;
}

bool has_copy_inside_limits(const Robot& robot, const std::vector<JointVector>& branches) {
  std::vector<JointVector> postures;
  for (const JointVector& branch : branches) append_turns(robot, branch, Turns::all, postures);
  return !postures.empty();
}

void expect_valid(const Robot& robot, const Pose& tcp, const std::vector<JointVector>& branches,
                  double pose_tolerance = 3e-10) {
  for (std::size_t i = 0; i < branches.size(); ++i) {
    EXPECT_LT(pose_error(tcp_pose(robot, branches[i]), tcp), pose_tolerance);
    for (int j = 0; j < robot.joint_count(); ++j) {
      const Joint& joint = robot.joints()[static_cast<std::size_t>(j)];
      const bool slides = joint.type == JointType::prismatic;
      EXPECT_GE(branches[i][j], slides ? joint.lower : std::nextafter(-kPi, 0.0));
      EXPECT_LE(branches[i][j], slides ? joint.upper : kPi);
    }
    for (std::size_t k = 0; k < i; ++k) EXPECT_GT(distance(robot, branches[i], branches[k]), 1e-5);
  }
}

/// How often a pose that a posture inside the limits reaches is solved inside the limits.
double share_solved(const std::shared_ptr<const Robot>& robot, int poses, unsigned seed) {
  const NumericInverseKinematics ik(robot);
  Dice dice(seed);
  int solved = 0;
  std::vector<JointVector> branches;
  for (int i = 0; i < poses; ++i) {
    const Pose tcp = tcp_pose(*robot, random_posture(*robot, dice));
    ik.solve(tcp, branches);
    expect_valid(*robot, tcp, branches);
    if (has_copy_inside_limits(*robot, branches)) ++solved;
  }
  return static_cast<double>(solved) / poses;
}

void expect_most_of(const test::UrClosedForm& closed_form,
                    const std::shared_ptr<const Robot>& robot) {
  const NumericInverseKinematics ik(robot);
  Dice dice(11);
  std::vector<JointVector> branches;
  int expected = 0, found = 0;
  for (int i = 0; i < 500; ++i) {
    const Pose tcp = tcp_pose(*robot, random_posture(*robot, dice));
    ik.solve(tcp, branches);
    const auto solutions = closed_form.solve(tcp);
    EXPECT_GE(solutions.size(), 2U);
    EXPECT_LE(branches.size(), solutions.size());
    for (const auto& solution : solutions) {
      const JointVector q = Eigen::Map<const Eigen::Matrix<double, 6, 1>>(solution.data());
      ++expected;
      if (std::any_of(branches.begin(), branches.end(), [&](const JointVector& branch) {
            return distance(*robot, branch, q) < 1e-4;
          }))
        ++found;
    }
  }
  EXPECT_GE(found, 0.995 * expected) << found << " of " << expected;
}

TEST(NumericIk, FindsTheSolutionsOfTheClosedFormOfOffsetWrists) {
  expect_most_of(test::ur5e_closed_form(), test::ur5e());
  expect_most_of(test::ur10e_closed_form(), test::ur10e());
}

TEST(NumericIk, SolvesWhatArmsReachInsideTheirLimits) {
  EXPECT_GE(share_solved(test::ur5e(), 400, 1), 0.995);
  EXPECT_GE(share_solved(test::ur10e(), 400, 2), 0.995);
  EXPECT_GE(share_solved(test::iiwa14(), 400, 3), 0.995);
  EXPECT_GE(share_solved(test::planar_3r(), 400, 4), 0.995);
}

TEST(NumericIk, HasBothElbowsOfThePlanarArm) {
  const auto robot = test::planar_3r();
  const NumericInverseKinematics ik(robot);
  Dice dice(5);
  std::vector<JointVector> branches;
  for (int i = 0; i < 200; ++i) {
    const JointVector q = random_posture(*robot, dice);
    ik.solve(tcp_pose(*robot, q), branches);
    ASSERT_EQ(branches.size(), 2U) << q.transpose();
    // Mirrored at the line from the shoulder to the wrist: links of 0.5 and 0.4 m.
    const double inner = std::atan2(0.4 * std::sin(q[1]), 0.5 + 0.4 * std::cos(q[1]));
    JointVector other(3);
    other << q[0] + 2 * inner, -q[1], q[2] + 2 * q[1] - 2 * inner;
    for (const JointVector& expected : {q, other}) {
      EXPECT_LT(std::min(distance(*robot, branches[0], expected),
                         distance(*robot, branches[1], expected)),
                1e-6);
    }
  }
}

TEST(NumericIk, TakesPosesOfAnArmThatMovesInAPlaneOnlyInThatPlane) {
  const auto robot = test::planar_3r();
  const NumericInverseKinematics ik(robot);
  const Pose tcp = tcp_pose(*robot, Eigen::Vector3d(0.3, 0.9, -0.5));
  std::vector<JointVector> branches;
  Pose moved = tcp;
  moved.translation().z() += 5e-10;
  ik.solve(moved, branches);
  EXPECT_EQ(branches.size(), 2U);
  expect_valid(*robot, moved, branches, 2e-9);
  moved.translation().z() += 1e-6;
  ik.solve(moved, branches);
  EXPECT_TRUE(branches.empty());
  moved = tcp;
  moved.rotate(Eigen::AngleAxisd(1e-6, Eigen::Vector3d::UnitX()));
  ik.solve(moved, branches);
  EXPECT_TRUE(branches.empty());
}

/// Random rows of random lengths; every third joint slides where `slides`.
std::shared_ptr<const Robot> random_chain(Dice& dice, int joints, bool slides) {
  std::vector<test::DhRow> rows;
  rows.reserve(static_cast<std::size_t>(joints));
  for (int j = 0; j < joints; ++j) {
    rows.push_back({dice.uniform(-0.3, 0.3), dice.uniform(-0.4, 0.4), dice.uniform(-kPi, kPi),
                    dice.uniform(1.5, 3)});
  }
  const auto turning = test::dh_arm("random", rows);
  Robot::Parts parts;
  parts.name = turning->name();
  parts.joints = turning->joints();
  parts.tcp = turning->tcp();
  for (std::size_t j = 0; slides && j < parts.joints.size(); j += 3) {
    parts.joints[j].type = JointType::prismatic;
    parts.joints[j].lower = -0.3;
    parts.joints[j].upper = 0.5;
  }
  return std::make_shared<const Robot>(parts);
}

TEST(NumericIk, SolvesRandomChainsOfOneToNineJoints) {
  for (const bool slides : {false, true}) {
    int solved = 0, poses = 0;
    for (int joints = 1; joints <= 9; ++joints) {
      Dice dice(static_cast<unsigned>(100 + joints));
      for (int chain = 0; chain < 3; ++chain) {
        const auto robot = random_chain(dice, joints, slides);
        const NumericInverseKinematics ik(robot);
        std::vector<JointVector> branches;
        for (int i = 0; i < 20; ++i, ++poses) {
          const Pose tcp = tcp_pose(*robot, random_posture(*robot, dice));
          ik.solve(tcp, branches);
          expect_valid(*robot, tcp, branches, 3e-9);
          if (has_copy_inside_limits(*robot, branches)) ++solved;
        }
      }
    }
    EXPECT_GE(solved, 0.985 * poses) << solved << " of " << poses;
  }
}

TEST(NumericIk, KeepsSolutionsOfAContinuumApartAndInsideTheLimits) {
  const auto robot = test::iiwa14();
  NumericIkOptions options;
  options.separation = 0.5;
  options.most_of_continuum = 10;
  const NumericInverseKinematics ik(robot, options);
  Dice dice(8);
  std::vector<JointVector> branches;
  for (int i = 0; i < 50; ++i) {
    ik.solve(tcp_pose(*robot, random_posture(*robot, dice)), branches);
    EXPECT_LE(branches.size(), 10U);
    for (std::size_t a = 0; a < branches.size(); ++a) {
      EXPECT_TRUE((branches[a].array() <= robot->upper_limits().array()).all());
      EXPECT_TRUE((branches[a].array() >= robot->lower_limits().array()).all());
      for (std::size_t b = 0; b < a; ++b)
        EXPECT_GE(distance(*robot, branches[a], branches[b]), 0.5);
    }
  }
}

TEST(NumericIk, FindsNothingOutOfReach) {
  std::vector<JointVector> branches = {JointVector::Zero(6)};
  for (const auto& robot : {test::iiwa14(), test::planar_3r()}) {
    const NumericInverseKinematics ik(robot);
    const Pose stretched = tcp_pose(*robot, JointVector::Zero(robot->joint_count()));
    const Eigen::Vector3d shoulder(0, 0, robot->joint_count() == 7 ? 0.36 : 0);
    for (const double beyond : {0.001, 0.01, 0.1, 1.0, 100.0}) {
      Pose tcp = stretched;
      tcp.translation() += beyond * (tcp.translation() - shoulder).normalized();
      ik.solve(tcp, branches);
      EXPECT_TRUE(branches.empty()) << robot->name() << " " << beyond;
    }
  }
  for (const auto& robot : {test::ur5e(), test::iiwa14(), test::planar_3r()}) {
    const NumericInverseKinematics ik(robot);
    Pose far = Pose::Identity();
    far.translation() << 3, 0, 0;
    ik.solve(far, branches);
    EXPECT_TRUE(branches.empty());
    far.translation().setConstant(std::numeric_limits<double>::quiet_NaN());
    ik.solve(far, branches);
    EXPECT_TRUE(branches.empty());
  }
}

TEST(NumericIk, ReachesSingularPosesAndTheLimitOfReach) {
  const auto expect_solved = [](const std::shared_ptr<const Robot>& robot, const JointVector& q) {
    const NumericInverseKinematics ik(robot);
    std::vector<JointVector> branches;
    ik.solve(tcp_pose(*robot, q), branches);
    EXPECT_FALSE(branches.empty()) << robot->name() << ": " << q.transpose();
    expect_valid(*robot, tcp_pose(*robot, q), branches);
  };
  for (const double off : {0.0, 1e-9, 1e-6, 1e-3}) {
    JointVector q(6);
    q << 0.4, -1.2, 1.3, -0.7, off, 0.9;  // axes 4 and 6 parallel
    expect_solved(test::ur5e(), q);
    q << 0.4, -1.2, off, -0.7, 1.1, 0.9;  // arm stretched
    expect_solved(test::ur5e(), q);
    expect_solved(test::planar_3r(), Eigen::Vector3d(0.7, off, 0.2));
    expect_solved(test::planar_3r(), Eigen::Vector3d(0.7, off, off));
    expect_solved(test::planar_3r(), Eigen::Vector3d(0.7, -2 + off, 2.6));
    JointVector r(7);
    r << 0.2, 0.5, -0.3, off, 0.4, 0.8, 0.1;  // arm stretched
    expect_solved(test::iiwa14(), r);
    r << 0.2, off, -0.3, 1.1, 0.4, off, 0.1;
    expect_solved(test::iiwa14(), r);
  }
}

TEST(NumericIk, OneSolutionWhereTwoMeet) {
  const auto robot = test::planar_3r();
  const NumericInverseKinematics ik(robot);
  std::vector<JointVector> branches;
  ik.solve(tcp_pose(*robot, Eigen::Vector3d(0.7, 0, 0.2)), branches);
  EXPECT_EQ(branches.size(), 1U);
  ik.solve(tcp_pose(*robot, Eigen::Vector3d(0.7, 0.01, 0.2)), branches);
  EXPECT_EQ(branches.size(), 2U);
}

TEST(NumericIk, DependsOnThePoseAlone) {
  const auto robot = test::ur5e();
  const NumericInverseKinematics ik(robot), again(robot);
  Dice dice(12);
  std::vector<Pose> poses;
  std::vector<std::vector<JointVector>> forwards(60), backwards(60);
  poses.reserve(60);
  for (int i = 0; i < 60; ++i) poses.push_back(tcp_pose(*robot, random_posture(*robot, dice)));
  parallel_for(60, 2, [&](int, std::size_t i) { ik.solve(poses[i], forwards[i]); });
  for (std::size_t i = 60; i-- > 0;) again.solve(poses[i], backwards[i]);
  EXPECT_EQ(forwards, backwards);
}

TEST(NumericIk, RefusesSenselessOptions) {
  test::invalid_input([] { NumericInverseKinematics ik(nullptr); });
  const auto refused = [](const auto& change) {
    NumericIkOptions options;
    change(options);
    test::invalid_input([&] { NumericInverseKinematics ik(test::planar_3r(), options); });
  };
  refused([](NumericIkOptions& o) { o.postures = 0; });
  refused([](NumericIkOptions& o) { o.neighbours = 0; });
  refused([](NumericIkOptions& o) { o.vain_starts = 0; });
  refused([](NumericIkOptions& o) { o.most_of_continuum = 0; });
  refused([](NumericIkOptions& o) { o.separation = std::nan(""); });
}

}  // namespace
}  // namespace wristwise
