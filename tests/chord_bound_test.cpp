#include "smoothing/chord_bound.hpp"

#include <gtest/gtest.h>

#include "random_arm.hpp"
#include "wristwise/kinematics.hpp"
#include "wristwise/seam.hpp"

namespace wristwise {
namespace {

using test::Dice;

Robot random_chain(Dice& dice, int joints) {
  Robot::Parts parts;
  for (int j = 0; j < joints; ++j) {
    Joint joint;
    joint.name = "j" + std::to_string(j);
    joint.type = dice.uniform(0, 1) < 0.3 ? JointType::prismatic : JointType::revolute;
    joint.origin.linear() = dice.rotation();
    joint.origin.translation() = dice.vector(0.5);
    joint.axis = dice.rotation().col(0);
    joint.lower = -4;
    joint.upper = 4;
    joint.max_velocity = joint.max_acceleration = joint.max_jerk = 1;
    parts.joints.push_back(joint);
  }
  parts.tcp.translation() = dice.vector(0.4);
  parts.tcp.linear() = dice.rotation();
  return Robot(parts);
}

struct Deviation {
  double position = 0, angle = 0;
};

/// Of the move from the line between its ends, sampled.
Deviation sampled(const Robot& robot, const JointVector& from, const JointVector& to) {
  SeamPiece line;
  line.from = tcp_pose(robot, from);
  line.to = tcp_pose(robot, to);
  Deviation most;
  for (int k = 1; k < 40; ++k) {
    const double s = k / 40.0;
    const Pose on_move = tcp_pose(robot, (1 - s) * from + s * to), on_line = line.frame_at(s);
    most.position = std::max(most.position, (on_move.translation() - on_line.translation()).norm());
    most.angle = std::max(
        most.angle, Eigen::AngleAxisd(on_line.linear().transpose() * on_move.linear()).angle());
  }
  return most;
}

TEST(ChordBound, HoldsForRandomChains) {
  Dice dice(11);
  for (int i = 0; i < 2000; ++i) {
    const int joints = 1 + i % 8;
    const Robot robot = random_chain(dice, joints);
    const JointVector from = dice.posture(joints);
    JointVector step(joints);
    for (double& value : step) value = dice.uniform(-1, 1);
    step *= dice.uniform(0.01, 1) / step.lpNorm<1>();
    const JointPath path{{0, 1}, {from, from + step}};
    const ChordBound bound(robot, path);
    const Deviation deviation = sampled(robot, from, from + step);
    EXPECT_LE(deviation.position, bound.position(step) + 1e-12);
    EXPECT_LE(deviation.angle, bound.angle(step) + 1e-7);  // AngleAxis near zero
  }
}

TEST(ChordBound, IsTightForOneTurningJoint) {
  Dice dice(12);
  Robot::Parts parts;
  parts.joints.push_back(
      {"j", JointType::revolute, Pose::Identity(), Eigen::Vector3d::UnitZ(), -3, 3, 1, 1, 1});
  parts.tcp.translation().x() = 0.7;
  const Robot robot(parts);
  JointVector from(1), step(1);
  from << 0.3;
  step << 0.2;
  const ChordBound bound(robot, {{0, 1}, {from, from + step}});
  const double sagitta = 0.7 * (1 - std::cos(0.1));
  EXPECT_GE(bound.position(step), sagitta);
  EXPECT_LT(bound.position(step), 1.01 * sagitta);
  EXPECT_EQ(bound.angle(step), 0);
}

TEST(ChordBound, PiecesStayWithinWhatWasAsked) {
  Dice dice(13);
  for (int i = 0; i < 200; ++i) {
    const Robot robot = random_chain(dice, 6);
    const JointVector from = dice.posture(6), to = dice.posture(6);
    const ChordBound bound(robot, {{0, 1}, {from, to}});
    const double pieces = bound.pieces(to - from, 1e-3, 2e-3);
    for (const double at : {0.0, std::floor(0.4 * pieces), pieces - 1}) {
      const Deviation deviation = sampled(robot, from + (at / pieces) * (to - from),
                                          from + ((at + 1) / pieces) * (to - from));
      EXPECT_LE(deviation.position, 1e-3);
      EXPECT_LE(deviation.angle, 2e-3);
    }
  }
}

TEST(ChordBound, OnePieceIsEnoughForSlidesAndForNoMove) {
  Robot::Parts parts;
  for (int j = 0; j < 3; ++j)
    parts.joints.push_back({"j" + std::to_string(j), JointType::prismatic, Pose::Identity(),
                            Eigen::Vector3d::Unit(j), -3, 3, 1, 1, 1});
  const Robot robot(parts);
  const JointVector zero = JointVector::Zero(3), far = JointVector::Constant(3, 2.5);
  const ChordBound bound(robot, {{0, 1}, {zero, far}});
  EXPECT_EQ(bound.pieces(far, 1e-6, 1e-6), 1);
  EXPECT_EQ(bound.pieces(zero, 1e-6, 1e-6), 1);
}

}  // namespace
}  // namespace wristwise
