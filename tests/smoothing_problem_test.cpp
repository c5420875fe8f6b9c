#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "collision_robots.hpp"
#include "gantry.hpp"
#include "invalid_input.hpp"
#include "wristwise/kinematics.hpp"
#include "wristwise/smoothing.hpp"

namespace wristwise {
namespace {

using test::invalid_input;
using test::says;
namespace gantry = test::gantry;

JointPath straight_path() {
  return {
      {5, 5.1, 5.2},
      {gantry::posture(0, 0, 0), gantry::posture(0.001, 0, 0), gantry::posture(0.002, 0, 0.001)}};
}

TEST(SmoothingProblem, RowsAreTheWaypoints) {
  const auto robot = gantry::robot();
  const JointPath path = straight_path();
  const SmoothingProblem made = smoothing_problem(robot, path);
  EXPECT_EQ(made.path.times, path.times);
  EXPECT_EQ(made.path.positions, path.positions);
  const Task& task = made.problem.task;
  ASSERT_EQ(task.waypoints.size(), 3u);
  EXPECT_EQ(task.seam.start_time(), 5);
  EXPECT_EQ(task.seam.end_time(), 5.2);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(task.waypoints[i].time, path.times[i]);
    EXPECT_TRUE(task.waypoints[i].frame.isApprox(tcp_pose(*robot, path.positions[i])));
  }
}

TEST(SmoothingProblem, WidenedBoxAndChordFitIntoTheBall) {
  SmoothingOptions options;
  options.position_tolerance = 2e-3;
  options.angle_tolerance = 0.02;
  const Task task = smoothing_problem(gantry::robot(), straight_path(), options).problem.task;
  const ToleranceBox wider =
      task.waypoints[1].tolerance.widened(task.between_position, task.between_angle);
  const Pose corner = pose_at_deviation(wider, Pose::Identity(), wider.upper);
  EXPECT_NEAR(corner.translation().norm(), 0.95 * 2e-3, 1e-12);
  EXPECT_NEAR(Eigen::AngleAxisd(corner.linear()).angle(), 0.95 * 0.02, 1e-9);
  EXPECT_GT(task.waypoints[1].tolerance.upper.minCoeff(), 0);
  EXPECT_GT(task.between_position, 0);
  EXPECT_GT(task.between_angle, 0);
}

TEST(SmoothingProblem, LongMovesGetPointsOnThem) {
  JointVector from = gantry::posture(0, 0, 0), to = gantry::posture(0.1, 0, 0, 1);
  const SmoothingProblem made = smoothing_problem(gantry::robot(), {{0, 2}, {from, to}});
  ASSERT_GE(made.path.size(), 11u);  // at most 20 tolerances of 0.5 mm apart
  for (std::size_t i = 0; i < made.path.size(); ++i) {
    const double s = made.path.times[i] / 2;
    EXPECT_TRUE(made.path.positions[i].isApprox((1 - s) * from + s * to) || s == 0);
  }
}

TEST(SmoothingProblem, InvalidInputIsNamed) {
  const auto robot = gantry::robot();
  const auto message = [&](const JointPath& path, const SmoothingOptions& options = {}) {
    return invalid_input([&] { smoothing_problem(robot, path, options); });
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(says(message({}), "joint path"));
  EXPECT_TRUE(says(message({{0}, {gantry::posture(0, 0, 0)}}), "at least two"));
  JointPath path = straight_path();
  path.positions[1][2] = nan;
  EXPECT_TRUE(says(message(path), "index 1"));
  path = straight_path();
  path.positions[2].resize(3);
  EXPECT_TRUE(says(message(path), "index 2"));
  path = straight_path();
  path.times[2] = path.times[1];
  EXPECT_TRUE(says(message(path), "increasing"));
  path.times[2] = path.times[1] + 1e-6;
  EXPECT_TRUE(says(message(path), "point 2"));
  for (const double bad : {0.0, -1.0, nan, std::numeric_limits<double>::infinity()}) {
    SmoothingOptions options;
    options.position_tolerance = bad;
    EXPECT_TRUE(says(message(straight_path(), options), "position tolerance"));
    options = {};
    options.angle_tolerance = bad;
    EXPECT_TRUE(says(message(straight_path(), options), "angle tolerance"));
    options = {};
    options.smoothing_time = bad;
    EXPECT_TRUE(says(message(straight_path(), options), "smoothing time"));
  }
  SmoothingOptions tiny;
  tiny.position_tolerance = 1e-15;
  path = {{0, 1}, {gantry::posture(0, 0, 0), gantry::posture(1, 0, 0, 1)}};
  Robot::Parts parts = gantry::parts();
  parts.tcp.translation().y() = 1;
  EXPECT_TRUE(says(invalid_input([&] { smoothing_problem(gantry::robot(parts), path, tiny); }),
                   "tolerance"));
}

TEST(SmoothingProblem, LinksThatTouchAlongThePathAreLeftOut) {
  const auto robot = test::arm();
  ClearanceChecker checker(std::make_shared<const ClearanceModel>(robot, Scene()));
  std::mt19937 random(3);
  JointVector touching, clear;
  while (touching.size() == 0 || clear.size() == 0) {
    const JointVector q = test::random_posture(*robot, random);
    checker.set_posture(q);
    (checker.first_below(0) ? touching : clear) = q;
  }
  checker.set_posture(touching);
  const auto [first, second] = checker.model().names(checker.first_below(0)->pair);
  const SmoothingProblem made = smoothing_problem(robot, {{0, 100}, {clear, touching}});
  const auto& disabled = made.problem.scene.disabled;
  EXPECT_EQ(std::count(disabled.begin(), disabled.end(), Scene::Names(first, second)), 1);
  ASSERT_EQ(made.warnings.size(), disabled.size());
  EXPECT_TRUE(says(made.warnings[0], "touch along the given path"));
  // The pairs that remain are clear at every point.
  ClearanceChecker remaining(std::make_shared<const ClearanceModel>(robot, made.problem.scene));
  for (const JointVector& q : made.path.positions) {
    remaining.set_posture(q);
    EXPECT_FALSE(remaining.first_below(0));
  }

  SmoothingOptions off;
  off.self_collision = false;
  EXPECT_EQ(smoothing_problem(robot, {{0, 100}, {clear, touching}}, off).problem.scene.scope,
            CollisionScope::off);
}

TEST(SmoothingProblem, SmoothingTimeIsThatOfThePathOrAsked) {
  EXPECT_NEAR(smoothing_problem(gantry::robot(), straight_path()).problem.refine.smoothing_time,
              0.05, 1e-12);
  SmoothingOptions options;
  options.smoothing_time = 0.7;
  EXPECT_EQ(
      smoothing_problem(gantry::robot(), straight_path(), options).problem.refine.smoothing_time,
      0.7);
}

}  // namespace
}  // namespace wristwise
