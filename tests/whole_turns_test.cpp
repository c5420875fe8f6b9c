#include "smoothing/whole_turns.hpp"

#include <gtest/gtest.h>

#include "wristwise/pose.hpp"

namespace wristwise {
namespace {

constexpr double kTurn = 6.28318530717958647692;

Robot one_joint(JointType type, double lower, double upper, double max_velocity = 5) {
  Robot::Parts parts;
  parts.joints.push_back({"wrist", type, Pose::Identity(), Eigen::Vector3d::UnitZ(), lower, upper,
                          max_velocity, 10, 100});
  return Robot(parts);
}

/// From `from` to `to` in steps of 0.05 s.
JointPath ramp(double from, double to, int count = 101) {
  JointPath path;
  for (int i = 0; i < count; ++i) {
    path.times.push_back(0.05 * i);
    path.positions.push_back(JointVector::Constant(1, from + (to - from) * i / (count - 1)));
  }
  return path;
}

JointPath wrapped(JointPath path) {
  for (JointVector& q : path.positions) q[0] = wrap_angle(q[0]);
  return path;
}

void expect_near(const JointPath& a, const JointPath& b) {
  ASSERT_EQ(a.times, b.times);
  for (std::size_t i = 0; i < a.size(); ++i)
    EXPECT_NEAR(a.positions[i][0], b.positions[i][0], 1e-12);
}

TEST(WholeTurns, WrappedRampsComeBack) {
  const Robot robot = one_joint(JointType::revolute, -6, 6);
  for (const auto& [from, to] : {std::pair{2.0, 5.0}, {-2.0, -5.5}, {5.9, -5.9}, {3.0, 3.3}}) {
    const JointPath path = ramp(from, to);
    const Unwrapped result = without_whole_turns(robot, wrapped(path));
    expect_near(result.path, path);
    ASSERT_EQ(result.warnings.size(), 1u);
    EXPECT_NE(result.warnings[0].find("wrist"), std::string::npos);
  }
}

TEST(WholeTurns, WithoutLimitsAnyNumberOfTurns) {
  const double inf = std::numeric_limits<double>::infinity();
  const Robot robot = one_joint(JointType::continuous, -inf, inf, 50);
  const JointPath path = ramp(0, 40, 401);
  const Unwrapped result = without_whole_turns(robot, wrapped(path));
  expect_near(result.path, path);
  EXPECT_NE(result.warnings.at(0).find("6 times"), std::string::npos);
}

TEST(WholeTurns, TheWholeCourseMovesInsideTheLimits) {
  // Unwrapped from its first value it would run from 3.0 to 4.5; the limits hold it a turn lower.
  const Robot robot = one_joint(JointType::revolute, -5, 3.5);
  const Unwrapped result = without_whole_turns(robot, wrapped(ramp(3.0, 4.5)));
  expect_near(result.path, ramp(3.0 - kTurn, 4.5 - kTurn));
}

TEST(WholeTurns, WithoutRoomItIsLeft) {
  const Robot robot = one_joint(JointType::revolute, -3, 3);
  const JointPath path = wrapped(ramp(1, 6));
  const Unwrapped result = without_whole_turns(robot, path);
  expect_near(result.path, path);
  EXPECT_NE(result.warnings.at(0).find("leave no room"), std::string::npos);
}

TEST(WholeTurns, WhatTheJointCanDoIsNoJump) {
  // Taught far apart: 5.5 rad in 2 s is a move.
  const Robot robot = one_joint(JointType::revolute, -6, 6);
  const JointPath path{{0, 2}, {JointVector::Constant(1, -2.75), JointVector::Constant(1, 2.75)}};
  const Unwrapped result = without_whole_turns(robot, path);
  EXPECT_EQ(result.path.positions, path.positions);
  EXPECT_TRUE(result.warnings.empty());
}

TEST(WholeTurns, SlidesDoNotWrap) {
  const Robot robot = one_joint(JointType::prismatic, -10, 10);
  const JointPath path{{0, 0.01}, {JointVector::Constant(1, -4), JointVector::Constant(1, 4)}};
  const Unwrapped result = without_whole_turns(robot, path);
  EXPECT_EQ(result.path.positions, path.positions);
  EXPECT_TRUE(result.warnings.empty());
}

}  // namespace
}  // namespace wristwise
