#include "graph/sparse_planner.hpp"

#include <gtest/gtest.h>

#include "graph_planning.hpp"
#include "wristwise/swept_clearance.hpp"

namespace wristwise {
namespace {

namespace gantry = test::gantry;
using gantry::Planning;

GraphPlan plan_sparsely(Planning& planning) {
  planning.options.planner = Planner::sparse;
  return planning.plan();
}

void expect_valid(Planning& planning, const JointPath& path) {
  ASSERT_EQ(path.size(), planning.task.waypoints.size());
  ClearanceChecker checker(planning.model);
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Waypoint& waypoint = planning.task.waypoints[i];
    const Vector6 e =
        deviation(waypoint.tolerance, waypoint.frame, tcp_pose(*planning.robot, path.positions[i]));
    EXPECT_LT(box_excess(waypoint.tolerance, e).maxCoeff(), 1e-9) << i;
    if (i == 0) continue;
    EXPECT_TRUE(check_motion(checker, StraightMove(path.positions[i - 1], path.positions[i]),
                             planning.required)
                    .clear)
        << i;
  }
}

TEST(SparsePlanner, NeedsFewPointsWhereTheWayIsClear) {
  Planning planning;
  planning.allow(1, 0.2, 0.1);
  const GraphPlan plan = plan_sparsely(planning);
  ASSERT_TRUE(plan.found);
  EXPECT_EQ(plan.statistics.sparse_points, 3U);
  EXPECT_EQ(plan.statistics.replans, 0);
  expect_valid(planning, plan.seeds.front().path);
  EXPECT_NEAR(plan.statistics.cost, 1, 1e-12);
}

TEST(SparsePlanner, AddsPointsAtAnObstacleBetweenTheFirstOnes) {
  Planning planning;
  planning.allow(1, 0.2, 0.05);
  planning.pull_to_seam(0.1);
  planning.objects = {gantry::obstacle(Sphere{0.05}, 0.25, 0, 0)};
  const GraphPlan plan = plan_sparsely(planning);
  ASSERT_TRUE(plan.found);
  EXPECT_GT(plan.statistics.sparse_points, 3U);
  EXPECT_LT(plan.statistics.sparse_points, 21U);
  EXPECT_GT(plan.statistics.replans, 0);
  expect_valid(planning, plan.seeds.front().path);
  planning.options.planner = Planner::dense;
  const GraphPlan dense = planning.plan();
  ASSERT_TRUE(dense.found);
  EXPECT_LT(dense.statistics.cost, 1.2 * plan.statistics.cost);
}

/// A seam that bends away from the chord of its ends.
TEST(SparsePlanner, ProjectsOntoTheSeamBetweenThePoints) {
  Planning planning;
  for (Waypoint& waypoint : planning.task.waypoints) {
    waypoint.frame.translation().z() = 0.04 * std::sin(3 * waypoint.time / 20);
  }
  planning.options.max_stray = gantry::kUnlimited;
  const GraphPlan plan = plan_sparsely(planning);
  ASSERT_TRUE(plan.found);
  expect_valid(planning, plan.seeds.front().path);
  EXPECT_EQ(plan.statistics.sparse_points, 3U);

  planning.options.sparse_deviation = 1e-4;
  const GraphPlan closer = plan_sparsely(planning);
  ASSERT_TRUE(closer.found);
  EXPECT_GT(closer.statistics.sparse_points, 3U);
  expect_valid(planning, closer.seeds.front().path);
}

TEST(SparsePlanner, SaysWhyThereIsNoPath) {
  Planning planning;
  planning.objects = {gantry::obstacle(Sphere{0.1}, 0.5, 0, 0)};
  const GraphPlan plan = plan_sparsely(planning);
  EXPECT_FALSE(plan.found);
  ASSERT_TRUE(plan.diagnosis.has_value());
  EXPECT_EQ(plan.diagnosis->reason, "collision");
}

TEST(SparsePlanner, OfOneWaypoint) {
  Planning planning;
  planning.task.waypoints.resize(1);
  const GraphPlan plan = plan_sparsely(planning);
  EXPECT_TRUE(plan.found);
  EXPECT_EQ(plan.seeds.front().path.size(), 1U);
}

/// Between neighbouring points, too, a move must not stray: the last waypoint is out of line.
TEST(SparsePlanner, KeepsMaxStrayBetweenNeighbouringPoints) {
  Planning planning;
  planning.options.max_stray = 0.01;
  planning.task.waypoints.back().frame.translation().y() = 0.2;
  const GraphPlan plan = plan_sparsely(planning);
  EXPECT_FALSE(plan.found);
  ASSERT_TRUE(plan.diagnosis.has_value());
  EXPECT_EQ(plan.diagnosis->waypoint, 20U);
  EXPECT_EQ(plan.diagnosis->counts->astray, 1U);
}

TEST(SparsePlanner, WithEagerChecksSaysWhyThereIsNoPath) {
  Planning planning;
  planning.options.collision_checks = CollisionChecks::eager;
  planning.objects = {gantry::obstacle(Sphere{0.1}, 0.5, 0, 0)};
  const GraphPlan plan = plan_sparsely(planning);
  EXPECT_FALSE(plan.found);
  ASSERT_TRUE(plan.diagnosis.has_value());
  EXPECT_EQ(plan.diagnosis->reason, "collision");
  EXPECT_EQ(plan.statistics.pieces.size(), 2U);
}

}  // namespace
}  // namespace wristwise
