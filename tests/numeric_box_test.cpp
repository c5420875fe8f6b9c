// Numeric inverse kinematics inside a tolerance box.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "dh_arms.hpp"
#include "invalid_input.hpp"
#include "kinematics/nearest_posture.hpp"
#include "random_arm.hpp"
#include "wristwise/kinematics.hpp"
#include "wristwise/numeric_inverse_kinematics.hpp"

namespace wristwise {
namespace {

using test::Dice;

constexpr double kPi = 3.14159265358979323846;

double distance(const JointVector& a, const JointVector& b) {
  double largest = 0;
  for (Eigen::Index j = 0; j < a.size(); ++j)
    largest = std::max(largest, std::abs(std::remainder(a[j] - b[j], 2 * kPi)));
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

std::shared_ptr<const Robot> random_chain(Dice& dice, int joints) {
  std::vector<test::DhRow> rows;
  rows.reserve(static_cast<std::size_t>(joints));
  for (int j = 0; j < joints; ++j) {
    rows.push_back({dice.uniform(-0.3, 0.3), dice.uniform(0.1, 0.4), dice.sign() * kPi / 2,
                    dice.uniform(2, 3)});
  }
  return test::dh_arm("random", rows);
}

ToleranceBox box_of(double position, double angle) {
  ToleranceBox box;
  box.lower << Eigen::Vector3d::Constant(-position), Eigen::Vector3d::Constant(-angle);
  box.upper = -box.lower;
  return box;
}

void set_free(ToleranceBox& box, int coordinate) {
  box.lower[coordinate] = -ToleranceBox::kFree;
  box.upper[coordinate] = ToleranceBox::kFree;
}

void expect_inside(const Robot& robot, const ToleranceBox& box, const Pose& frame,
                   const std::vector<JointVector>& postures) {
  for (const JointVector& q : postures) {
    const Vector6 e = deviation(box, frame, tcp_pose(robot, q));
    EXPECT_LE(box_excess(box, e).maxCoeff(), 2e-9) << e.transpose();
    std::vector<JointVector> copies;
    EXPECT_GT(append_turns(robot, q, Turns::all, copies), 0) << q.transpose();
    EXPECT_LE(q.cwiseAbs().maxCoeff(), kPi);
  }
}

TEST(NumericBox, ABoxWithoutWidthHasTheSolutionsOfThePoseInsideTheLimits) {
  const auto robot = test::planar_3r();
  const NumericInverseKinematics ik(robot);
  Dice dice(1);
  for (int i = 0; i < 40; ++i) {
    const Pose frame = tcp_pose(*robot, random_posture(*robot, dice));
    std::vector<JointVector> postures, branches, inside;
    ik.solve_in_box(ToleranceBox{}, frame, postures);
    expect_inside(*robot, ToleranceBox{}, frame, postures);
    ik.solve(frame, branches);
    for (const JointVector& branch : branches) append_turns(*robot, branch, Turns::all, inside);
    ASSERT_EQ(postures.size(), inside.size());
    for (const JointVector& q : inside) {
      EXPECT_TRUE(std::any_of(postures.begin(), postures.end(),
                              [&](const JointVector& p) { return distance(p, q) < 1e-6; }));
    }
  }
}

/// The spin at which five joints reach a point with the torch's direction given is not known
/// before.
TEST(NumericBox, FiveJointsReachADirectionWithFreeSpin) {
  int solved = 0, poses = 0;
  for (unsigned chain = 0; chain < 4; ++chain) {
    Dice dice(20 + chain);
    const auto robot = random_chain(dice, 5);
    const NumericInverseKinematics ik(robot);
    EXPECT_FALSE(ik.meets_every_pose());
    ToleranceBox box;
    set_free(box, 5);
    for (int i = 0; i < 25; ++i, ++poses) {
      Pose frame = tcp_pose(*robot, random_posture(*robot, dice));
      frame.rotate(Eigen::AngleAxisd(dice.uniform(-kPi, kPi), Eigen::Vector3d::UnitZ()));
      std::vector<JointVector> postures;
      ik.solve(frame, postures);
      EXPECT_TRUE(postures.empty());
      ik.solve_in_box(box, frame, postures);
      expect_inside(*robot, box, frame, postures);
      if (!postures.empty()) ++solved;
    }
  }
  EXPECT_GE(solved, 0.98 * poses) << solved << " of " << poses;
}

TEST(NumericBox, ASampleStandsForItsPartOfTheBox) {
  Dice dice(31);
  const auto robot = random_chain(dice, 5);
  const NumericInverseKinematics ik(robot);
  int solved = 0;
  for (int i = 0; i < 30; ++i) {
    const double spin = dice.uniform(-kPi, kPi);
    ToleranceSample sample;
    sample.path_frame = tcp_pose(*robot, random_posture(*robot, dice)) *
                        Eigen::AngleAxisd(-spin, Eigen::Vector3d::UnitZ());
    set_free(sample.box, 5);
    std::vector<JointVector> branches;
    sample.deviation[5] = spin + 0.05;
    sample.lower[5] = spin - 0.04;
    sample.upper[5] = spin + 0.14;
    ik.solve_near(sample, branches);
    expect_inside(*robot, sample.box, sample.path_frame, branches);
    for (const JointVector& q : branches) {
      const Vector6 e = deviation(sample.box, sample.path_frame, tcp_pose(*robot, q));
      EXPECT_LT(std::abs(std::remainder(e[5] - sample.deviation[5], 2 * kPi)), 0.09 + 1e-9);
    }
    if (!branches.empty()) ++solved;
  }
  EXPECT_GE(solved, 28);
}

TEST(NumericBox, ThePlanarArmUsesItsToleranceInX) {
  const auto robot = test::planar_3r();
  const NumericInverseKinematics ik(robot);
  ToleranceBox box;
  box.lower[0] = -0.05;
  box.upper[0] = 0.05;
  // Beyond its reach of 1.1 m along x by 30 mm, the last link turned along x.
  Pose frame = Pose::Identity();
  frame.translation() << 1.13, 0, 0;
  std::vector<JointVector> postures;
  ik.solve(frame, postures);
  EXPECT_TRUE(postures.empty());
  ik.solve_in_box(box, frame, postures);
  EXPECT_GE(postures.size(), 2U);
  expect_inside(*robot, box, frame, postures);
  frame.translation() << 1.16, 0, 0;
  ik.solve_in_box(box, frame, postures);
  EXPECT_TRUE(postures.empty());
}

TEST(NumericBox, KeepsPosturesOfAContinuumApart) {
  for (const auto& robot : {test::ur5e(), test::iiwa14()}) {
    const NumericInverseKinematics ik(robot);
    Dice dice(41);
    for (const ToleranceFrame frame_of_box : {ToleranceFrame::path, ToleranceFrame::base}) {
      ToleranceBox box = box_of(0.01, 0.1);
      box.frame = frame_of_box;
      for (int i = 0; i < 5; ++i) {
        const Pose frame = tcp_pose(*robot, random_posture(*robot, dice));
        std::vector<JointVector> postures;
        ik.solve_in_box(box, frame, postures);
        EXPECT_GE(postures.size(), 2U);
        EXPECT_LE(postures.size(), 32U);
        expect_inside(*robot, box, frame, postures);
        for (std::size_t a = 0; a < postures.size(); ++a) {
          for (std::size_t b = 0; b < a; ++b) EXPECT_GE(distance(postures[a], postures[b]), 0.3);
        }
      }
    }
  }
}

TEST(NumericBox, RefusesABoxThatIsNone) {
  const NumericInverseKinematics ik(test::planar_3r());
  std::vector<JointVector> postures;
  ToleranceBox box;
  box.lower[0] = 1;
  test::invalid_input([&] { ik.solve_in_box(box, Pose::Identity(), postures); });
  Pose nowhere = Pose::Identity();
  nowhere.translation().setConstant(std::nan(""));
  ik.solve_in_box(ToleranceBox{}, nowhere, postures);
  EXPECT_TRUE(postures.empty());
}

/// Values against differences of values a small step to either side.
void expect_gradients(const Robot& robot, const DeviationCell& cell, const JointVector& q) {
  const NearestPosture problem(robot, cell, q + JointVector::Constant(q.size(), 0.1));
  constexpr double kStep = 1e-6;
  const Eigen::Index equal = problem.equality_count(), bounded = problem.inequality_count();
  NearestPosture::Rows of_equal, of_bounded, unused;
  Eigen::VectorXd value(equal), sides(bounded);
  problem.equalities(q, value, of_equal);
  problem.inequalities(q, sides, of_bounded);
  for (Eigen::Index j = 0; j < q.size(); ++j) {
    JointVector before = q, after = q;
    before[j] -= kStep;
    after[j] += kStep;
    const double slope = (problem.objective(after) - problem.objective(before)) / (2 * kStep);
    EXPECT_NEAR(problem.objective_gradient(q)[j], slope, 1e-8);
    Eigen::VectorXd low(equal), high(equal);
    problem.equalities(before, low, unused);
    problem.equalities(after, high, unused);
    EXPECT_LT(((high - low) / (2 * kStep) - of_equal.col(j)).norm(), 1e-7);
    Eigen::VectorXd low_side(bounded), high_side(bounded);
    problem.inequalities(before, low_side, unused);
    problem.inequalities(after, high_side, unused);
    EXPECT_LT(((high_side - low_side) / (2 * kStep) - of_bounded.col(j)).norm(), 1e-7);
  }
}

TEST(NearestPosture, GradientsAreNumericDifferences) {
  Dice dice(51);
  for (const auto& robot : {test::ur5e(), test::iiwa14(), test::planar_3r()}) {
    for (int i = 0; i < 20; ++i) {
      JointVector q = random_posture(*robot, dice);
      if (i % 4 == 0) q.setConstant(i == 0 ? 0 : 1e-9);  // singular
      DeviationCell cell;
      cell.path_frame = tcp_pose(*robot, q + 0.05 * JointVector::Ones(q.size()));
      cell.box = box_of(0.01, 0.1);
      cell.box.lower[1] = cell.box.upper[1] = 0;
      cell.box.lower[3] = cell.box.upper[3] = 0.02;
      if (i % 2 == 1) set_free(cell.box, 5);
      cell.box.frame = i % 3 == 0 ? ToleranceFrame::base : ToleranceFrame::path;
      if (cell.box.frame == ToleranceFrame::base && i % 4 == 0) continue;  // angles may be singular
      cell.lower = cell.box.lower;
      cell.upper = cell.box.upper;
      expect_gradients(*robot, cell, q);
    }
  }
}

TEST(NearestPosture, LeavesOutWhatTheChainCantMove) {
  const auto robot = test::planar_3r();
  const JointVector q = Eigen::Vector3d(0.3, 0.8, -0.4);
  DeviationCell cell = DeviationCell::of(ToleranceBox{}, tcp_pose(*robot, q));
  EXPECT_EQ(NearestPosture(*robot, cell, q).equality_count(), 3);
  EXPECT_EQ(NearestPosture(*test::ur5e(), cell, test::ur5e()->lower_limits() / 7).equality_count(),
            6);
}

}  // namespace
}  // namespace wristwise
