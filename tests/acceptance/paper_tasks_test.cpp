// The welding tasks of De Maeyer et al. (ETFA 2017): what they show. That they are solved is for
// shipped_problems_test.cpp to say.

#include <gtest/gtest.h>

#include <cmath>

#include "wristwise/wristwise.hpp"

namespace wristwise {
namespace {

Problem shipped(const std::string& name) {
  return load_problem(std::string(WRISTWISE_SOURCE_DIR) + "/problems/" + name + ".yaml");
}

double peak(const JointPath& path, int derivative, int joint) {
  double largest = 0;
  for (const JointVector& value : divided_differences(path, derivative)) {
    largest = std::max(largest, std::abs(value[joint]));
  }
  return largest;
}

TEST(TaskB, CannotBeWeldedWithTheNominalTorch) {
  Problem problem = shipped("task_b_l_profile");
  for (Waypoint& waypoint : problem.task.waypoints) {
    waypoint.tolerance.lower[4] = waypoint.tolerance.upper[4] = 0;
  }
  const PlanResult result = plan_graph_only(problem);
  EXPECT_EQ(result.status, Status::infeasible);
  ASSERT_FALSE(result.diagnosis.empty());
  EXPECT_EQ(result.diagnosis.front().reason, "collision");
  EXPECT_NE(result.diagnosis.front().detail.find("torch - plate"), std::string::npos);
}

TEST(TaskBJump, IsInfeasibleInBothModesAndNamesThePlate) {
  const Problem problem = shipped("task_b_jump");
  for (const PlanResult& result : {plan(problem), plan_graph_only(problem)}) {
    EXPECT_EQ(result.status, Status::infeasible);
    ASSERT_FALSE(result.diagnosis.empty());
    EXPECT_TRUE(result.diagnosis.front().waypoint.has_value());
    EXPECT_NE(result.diagnosis.front().detail.find("torch - plate"), std::string::npos)
        << result.diagnosis.front().detail;
    EXPECT_GT(result.path.size(), 10U);  // the part that can be welded
    EXPECT_LT(result.path.size(), problem.task.waypoints.size());
  }
}

/// Every waypoint has clear postures: a planner that checks waypoints alone would jump through the
/// plate, as the paper found. It is the moves that are blocked, and the plate alone blocks them.
TEST(TaskBJump, IsBlockedByThePlateBetweenWaypoints) {
  Problem problem = shipped("task_b_jump");
  problem.graph.try_relaxations = false;
  const PlanResult checked = plan_graph_only(problem);
  const Diagnosis& diagnosis = checked.diagnosis.front();
  EXPECT_NE(diagnosis.detail.find("every move from waypoint"), std::string::npos);
  EXPECT_EQ(checked.path.size(), *diagnosis.waypoint);
  problem.scene.objects.pop_back();  // the plate
  EXPECT_EQ(plan_graph_only(problem).status, Status::solved);
}

/// The Descartes algorithm jumps through the plate; the verification says so.
TEST(TaskBJump, WithoutChecksOfMovesJumpsThroughThePlateAndFails) {
  Problem problem = shipped("task_b_jump");
  problem.graph.check_moves = false;
  const PlanResult result = plan_graph_only(problem);
  EXPECT_EQ(result.status, Status::failed);
  ASSERT_EQ(result.path.size(), problem.task.waypoints.size());
  ClearanceChecker checker(std::make_shared<const ClearanceModel>(problem.robot, problem.scene));
  double largest_turn = 0;
  for (std::size_t i = 0; i < result.path.size(); ++i) {
    checker.set_posture(result.path.positions[i]);
    EXPECT_GE(checker.nearest()->distance, problem.scene.clearance) << "at waypoint " << i;
    if (i == 0) continue;
    const Pose step = tcp_pose(*problem.robot, result.path.positions[i - 1]).inverse() *
                      tcp_pose(*problem.robot, result.path.positions[i]);
    largest_turn = std::max(largest_turn, Eigen::AngleAxisd(step.linear()).angle());
  }
  EXPECT_GT(largest_turn, 0.5);
  ASSERT_TRUE(result.verification.clearance.has_value());
  EXPECT_LT(*result.verification.clearance, 0);
  problem.scene.objects = {problem.scene.objects.back()};  // the plate alone
  ClearanceChecker plate(std::make_shared<const ClearanceModel>(problem.robot, problem.scene));
  double deepest = 1;
  for (std::size_t i = 0; i + 1 < result.path.size(); ++i) {
    for (double s = 0.05; s < 1; s += 0.05) {
      plate.set_posture((1 - s) * result.path.positions[i] + s * result.path.positions[i + 1]);
      deepest = std::min(deepest, plate.nearest()->distance);
    }
  }
  EXPECT_LT(deepest, -0.001);
}

TEST(TaskC, TwoStageTakesTheSpikesOutOfJoints4And6) {
  const Problem problem = shipped("task_c_wrist_singularity");
  const PlanResult graph_only = plan_graph_only(problem);
  const PlanResult two_stage = plan(problem);
  double least_joint5 = 1;
  for (const JointVector& q : graph_only.path.positions) {
    least_joint5 = std::min(least_joint5, std::abs(q[4]));
  }
  EXPECT_LT(least_joint5, 0.06);  // the seam does pass the singularity
  for (const int joint : {3, 5}) {
    for (const int derivative : {2, 3}) {
      EXPECT_GE(peak(graph_only.path, derivative, joint),
                5 * peak(two_stage.path, derivative, joint))
          << "joint " << joint + 1 << ", derivative " << derivative;
    }
  }
}

TEST(Plan, GivesTheSameBytesWithAnyNumberOfThreads) {
  const Problem problem = shipped("task_b_l_profile");
  PlanOptions one, three;
  one.threads = 1;
  three.threads = 3;
  const PlanResult a = plan(problem, one), b = plan(problem, three);
  ASSERT_EQ(a.path.size(), b.path.size());
  for (std::size_t i = 0; i < a.path.size(); ++i) {
    EXPECT_EQ(a.trajectory.positions()[i], b.trajectory.positions()[i]);
    EXPECT_EQ(a.trajectory.accelerations()[i], b.trajectory.accelerations()[i]);
  }
  EXPECT_EQ(a.graph.postures_checked, b.graph.postures_checked);
  EXPECT_EQ(a.graph.edges_checked, b.graph.edges_checked);
}

TEST(Plan, StopsWhenCancelled) {
  const std::atomic<bool> cancel{true};
  PlanOptions options;
  options.monitor.cancel = &cancel;
  EXPECT_EQ(plan(shipped("task_c_wrist_singularity"), options).status, Status::interrupted);
}

TEST(Plan, ReportsItsStages) {
  std::vector<std::string> stages;
  PlanOptions options;
  options.monitor.progress = [&](const std::string& stage, double fraction) {
    EXPECT_GE(fraction, 0);
    EXPECT_LE(fraction, 1);
    if (stages.empty() || stages.back() != stage) stages.push_back(stage);
  };
  plan(shipped("task_c_wrist_singularity"), options);
  EXPECT_EQ(stages, (std::vector<std::string>{"sampling", "search", "refine", "verify"}));
}

}  // namespace
}  // namespace wristwise
