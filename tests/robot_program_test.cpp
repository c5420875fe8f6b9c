// Which points of a curve become points of a program, and which of its moves weld.

#include "wristwise/robot_program.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "export_example.hpp"
#include "invalid_input.hpp"
#include "recording.hpp"
#include "wristwise/kinematics.hpp"

namespace wristwise {
namespace {

using test::export_example;
using test::ExportExample;
using test::invalid_input;
using test::says;

/// Sines in all joints for 8 s; run-in to 1 s, run-out from 6.9 s.
ExportExample curve_example(double rate) {
  ExportExample example = export_example();
  test::Swing swing{JointVector::Constant(7, 0.3), JointVector::Constant(7, 0.2),
                    JointVector::Constant(7, rate)};
  std::vector<double> times;
  std::vector<JointVector> q, v, a;
  for (int i = 0; i <= 32; ++i) {
    const double t = 0.25 * i;
    times.push_back(t);
    q.push_back(swing.at(t));
    v.push_back(swing.at(t, 1));
    a.push_back(swing.at(t, 2));
  }
  example.result.trajectory = Trajectory(times, q, v, a);
  example.result.path = example.result.trajectory.waypoints();
  example.problem.task = test::task_with_runs({0, 1, 3.3, 6.9, 8});
  return example;
}

double angle_between(const Pose& a, const Pose& b) {
  return std::abs(Eigen::AngleAxisd(a.linear().transpose() * b.linear()).angle());
}

/// The farthest that the program is from the curve, looked at every ms.
std::pair<double, double> measured_deviation(const RobotProgram& program,
                                             const ExportExample& example) {
  double position = 0, angle = 0;
  const Robot& robot = *example.problem.robot;
  for (std::size_t i = 1; i < program.points.size(); ++i) {
    const ProgramPoint &from = program.points[i - 1], &to = program.points[i];
    for (double t = from.time; t < to.time; t += 1e-3) {
      const double share = (t - from.time) / (to.time - from.time);
      const Pose moved = tcp_pose(robot, (1 - share) * from.joints + share * to.joints);
      const Pose meant = tcp_pose(robot, example.result.trajectory.evaluate(t));
      position = std::max(position, (moved.translation() - meant.translation()).norm());
      angle = std::max(angle, angle_between(moved, meant));
    }
  }
  return {position, angle};
}

TEST(RobotProgram, StaysWithinTheDeviationAndSaysHowFar) {
  for (const double rate : {0.3, 1.0, 3.0}) {
    for (const double limit : {5e-5, 1e-3}) {
      ExportExample example = curve_example(rate);
      example.problem.exports.max_deviation = limit;
      example.problem.exports.max_angle_deviation = 10 * limit;
      const RobotProgram program = robot_program(example.result, example.problem);
      const auto [position, angle] = measured_deviation(program, example);
      EXPECT_LE(program.deviation, limit);
      EXPECT_LE(program.angle_deviation, 10 * limit);
      EXPECT_NEAR(position, program.deviation, 0.02 * limit);
      EXPECT_NEAR(angle, program.angle_deviation, 0.2 * limit);
    }
  }
}

TEST(RobotProgram, PointsAreNoCloserThanTheControllersPeriod) {
  ExportExample example = curve_example(3);
  example.problem.exports.max_deviation = 1e-9;
  const RobotProgram program = robot_program(example.result, example.problem);
  EXPECT_EQ(program.points.size(), 2001u);  // 8 s, 4 ms
  EXPECT_GT(program.deviation, 1e-9) << "how far it is off is said all the same";
  EXPECT_NEAR(measured_deviation(program, example).first, program.deviation,
              0.02 * program.deviation);
}

TEST(RobotProgram, TakesNoMorePointsThanItNeeds) {
  ExportExample example = curve_example(1);
  example.problem.exports.max_angle_deviation = 1;
  const RobotProgram program = robot_program(example.result, example.problem);
  // Without one of its points the deviation would be too large, but for those at ends of the weld.
  for (std::size_t i = 1; i + 1 < program.points.size(); ++i) {
    const double t = program.points[i].time;
    if (std::abs(t - 1) < 1e-9 || std::abs(t - 6.9) < 1e-9) continue;
    RobotProgram without;
    without.points = {program.points[i - 1], program.points[i + 1]};
    EXPECT_GT(measured_deviation(without, example).first, 5e-5) << t;
  }
}

TEST(RobotProgram, WeldStartsAndEndsAtAPoint) {
  const ExportExample example = curve_example(1);
  const RobotProgram program = robot_program(example.result, example.problem);
  const auto has_point = [&](double t) {
    return std::any_of(program.points.begin(), program.points.end(),
                       [&](const ProgramPoint& point) { return point.time == t; });
  };
  EXPECT_TRUE(has_point(0));
  EXPECT_TRUE(has_point(1));
  EXPECT_TRUE(has_point(6.9));
  EXPECT_TRUE(has_point(8));
  for (std::size_t i = 1; i < program.points.size(); ++i)
    EXPECT_EQ(program.points[i].welding,
              program.points[i - 1].time >= 1 && program.points[i].time <= 6.9);
}

TEST(RobotProgram, APeriodGivesAPointEveryPeriod) {
  ExportExample example = curve_example(1);
  example.problem.exports.period = 0.05;
  const RobotProgram program = robot_program(example.result, example.problem);
  ASSERT_EQ(program.points.size(), 161u);
  for (std::size_t i = 1; i < program.points.size(); ++i)
    EXPECT_NEAR(program.points[i].time - program.points[i - 1].time, 0.05, 1e-12);
  const auto [position, angle] = measured_deviation(program, example);
  EXPECT_NEAR(position, program.deviation, 0.02 * position);
  EXPECT_NEAR(angle, program.angle_deviation, 0.05 * angle);
}

TEST(RobotProgram, MovesToJointWaypointsDoNotWeld) {
  ExportExample example = export_example();
  SeamPiece line, move;
  line.start_time = -1;
  line.end_time = 2;
  move.kind = SeamPiece::Kind::move;
  move.start_time = 2;
  move.end_time = 3.5;
  example.problem.task.seam = Seam({line, move});
  for (Waypoint& waypoint : example.problem.task.waypoints) waypoint.welding = true;
  const RobotProgram program = robot_program(example.result, example.problem);
  std::vector<bool> welding;
  for (const ProgramPoint& point : program.points) welding.push_back(point.welding);
  EXPECT_EQ(welding, (std::vector<bool>{false, true, true, true, false}));
}

TEST(RobotProgram, NothingToExportIsSaid) {
  ExportExample example = export_example();
  example.result.path = {};
  EXPECT_TRUE(
      says(invalid_input([&] { robot_program(example.result, example.problem); }), "export"));
  example = export_example();
  example.result.path.times = {1};
  example.result.path.positions.resize(1);
  invalid_input([&] { robot_program(example.result, example.problem); });
}

TEST(RobotProgram, OptionsOutOfRangeAreSaid) {
  for (const double bad : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
    ExportExample example = curve_example(1);
    example.problem.exports.max_deviation = bad;
    EXPECT_TRUE(says(invalid_input([&] { robot_program(example.result, example.problem); }),
                     "max_deviation"));
    example = curve_example(1);
    example.problem.exports.period = bad;
    EXPECT_TRUE(
        says(invalid_input([&] { robot_program(example.result, example.problem); }), "period"));
    example = export_example();
    example.problem.exports.approach_percent = bad;
    EXPECT_TRUE(says(invalid_input([&] { robot_program(example.result, example.problem); }),
                     "approach_percent"));
  }
}

}  // namespace
}  // namespace wristwise
