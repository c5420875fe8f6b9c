// The problems of docs/paper: what their pictures are said to show.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "wristwise/wristwise.hpp"

namespace wristwise {
namespace {

constexpr double kDegree = 0.017453292519943295;
constexpr int kWork = 4;  // ry

Problem problem_of(const std::string& name) {
  return load_problem(std::string(WRISTWISE_SOURCE_DIR) + "/docs/paper/" + name + ".yaml");
}

/// |ry| at each waypoint, deg, of a result that must be solved.
std::vector<double> work_angles(const Problem& problem, const PlanResult& result) {
  std::vector<double> angles;
  EXPECT_EQ(result.status, Status::solved);
  for (std::size_t i = 0; i < problem.task.waypoints.size() && i < result.path.size(); ++i) {
    const Waypoint& waypoint = problem.task.waypoints[i];
    const JointVector q = result.trajectory.empty() ? result.path.positions[i]
                                                    : result.trajectory.evaluate(waypoint.time);
    const Vector6 e = deviation(waypoint.tolerance, waypoint.frame, tcp_pose(*problem.robot, q));
    angles.push_back(std::abs(e[kWork]) / kDegree);
  }
  return angles;
}

double peak_speed(const PlanResult& result, int joint) {
  double peak = 0;
  for (const JointVector& value : divided_differences(result.path, 1))
    peak = std::max(peak, std::abs(value[joint]));
  return peak;
}

TEST(PaperFigure8, AllJointsComeRoundAndJoint6TurnsAWholeTurn) {
  const Problem problem = problem_of("task_a_100_points");
  for (const PlanResult& result : {plan_graph_only(problem), plan(problem)}) {
    ASSERT_EQ(result.status, Status::solved);
    const JointVector moved = result.path.positions.back() - result.path.positions.front();
    EXPECT_GT(std::abs(moved[5]), 5.5);
  }
}

TEST(PaperFigure10, IsTheShippedProblemWithoutChecksOfMoves) {
  const Problem problem = problem_of("task_b_unchecked_moves");
  const Problem shipped =
      load_problem(std::string(WRISTWISE_SOURCE_DIR) + "/problems/task_b_jump.yaml");
  EXPECT_FALSE(problem.graph.check_moves);
  EXPECT_TRUE(shipped.graph.check_moves);
  EXPECT_EQ(problem.graph.step, shipped.graph.step);
  ASSERT_EQ(problem.task.waypoints.size(), shipped.task.waypoints.size());
  for (std::size_t i = 0; i < problem.task.waypoints.size(); ++i)
    EXPECT_TRUE(problem.task.waypoints[i].frame.isApprox(shipped.task.waypoints[i].frame, 1e-12));
}

TEST(PaperFigure14, JointMotionAloneDeviatesAllAlongTheCostOfDeviationOnlyAtThePlate) {
  const Problem standard = problem_of("task_b_standard_cost");
  const auto constant = work_angles(standard, plan_graph_only(standard));
  EXPECT_NEAR(*std::min_element(constant.begin(), constant.end()), constant.front(), 1e-6);
  EXPECT_NEAR(*std::max_element(constant.begin(), constant.end()), constant.front(), 1e-6);
  EXPECT_NEAR(constant.front(), 9.5, 1e-6);

  const Problem improved = problem_of("task_b_improved_cost");
  const auto angles = work_angles(improved, plan_graph_only(improved));
  const std::size_t half = angles.size() / 2;
  EXPECT_NEAR(angles.front(), 0, 1e-6);
  EXPECT_NEAR(angles.back(), 0, 1e-6);
  EXPECT_NEAR(angles[half], 4.5, 1e-6);
  const auto upright =
      std::count_if(angles.begin(), angles.end(), [](double a) { return a < 1e-6; });
  EXPECT_GT(upright, 30);

  const PlanResult refined = plan(improved);
  const auto smooth = work_angles(improved, refined);
  EXPECT_LT(*std::max_element(smooth.begin(), smooth.end()), 5);
  EXPECT_LT(peak_speed(refined, 4), 0.2 * peak_speed(plan_graph_only(improved), 4));
}

TEST(PaperFigure13, Joints4And6RunInOppositeDirectionsWhereJoint5IsSmall) {
  const Problem problem = problem_of("task_c_past_the_plate");
  const PlanResult result = plan_graph_only(problem);
  ASSERT_EQ(result.status, Status::solved);
  const auto& positions = result.path.positions;
  for (const JointVector& q : positions) EXPECT_GT(q[4] * positions.front()[4], 0);
  EXPECT_GT(std::abs(positions.front()[4]), 0.4);
  const JointVector middle = positions[positions.size() / 2];
  EXPECT_LT(std::abs(middle[4]), 0.1);
  const auto speed = divided_differences(result.path, 1);
  const JointVector fastest = speed[speed.size() / 2];
  EXPECT_LT(fastest[3] * fastest[5], 0);
  EXPECT_NEAR(fastest[3], -fastest[5], 0.02 * std::abs(fastest[3]));
  EXPECT_GT(std::abs(fastest[3]), 20 * std::abs(fastest[4]));
}

TEST(PaperFigure13, WithAFewDegreesOfSpinStage2GoesStraightThrough) {
  const Problem problem = problem_of("task_c_with_spin");
  const PlanResult graph = plan_graph_only(problem), refined = plan(problem);
  ASSERT_EQ(graph.status, Status::solved);
  ASSERT_EQ(refined.status, Status::solved);
  for (const int joint : {3, 4, 5})
    EXPECT_LT(10 * peak_speed(refined, joint), peak_speed(graph, joint));
}

}  // namespace
}  // namespace wristwise
