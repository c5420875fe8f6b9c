// Stage 1 with a joint to spare, against a plain dynamic programme over postures of the six-axis
// arm that is moved by hand, and against the six-axis planner run once for each place of the rail.

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "temporary_folder.hpp"
#include "wristwise/error.hpp"
#include "wristwise/plan.hpp"
#include "wristwise/urdf.hpp"

namespace wristwise {
namespace {

using test::TemporaryFolder;

constexpr double kPi = 3.14159265358979323846;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kCarriage = 0.35;  // m, height of the arm's base

std::string robot_file(const std::string& name) {
  return fmt::format("{}/robots/{}/{}.urdf", WRISTWISE_SOURCE_DIR, name, name);
}

std::string limits_file(const std::string& name) {
  return fmt::format("{}/robots/{}/joint_limits.yaml", WRISTWISE_SOURCE_DIR, name);
}

/// A short line along the rail; `shift` moves it in the frame of the robot's base.
Problem problem(const TemporaryFolder& folder, const std::string& robot, const std::string& samples,
                const Eigen::Vector3d& shift, const std::string& turns) {
  return load_problem(
      folder.write("line.yaml", fmt::format(R"(robot: {{urdf: {}, limits: {}, tip_link: torch_tip}}
scene: {{collision: off}}
path:
  frame: {{xyz: [{:.17g}, {:.17g}, {:.17g}]}}
  speed: 0.2
  waypoints: 5
  segments:
    - line: {{from: {{xyz: [0, 0, 0], rpy: [0, 180 deg, 0]}}, to: {{xyz: [0, 0.5, 0], rpy: [0, 180 deg, 0]}}}}
  tolerance: {{rz: free}}
graph: {{samples: {{rz: 60 deg{}}}, turns: {}, max_stray: off, try_relaxations: false}}
)",
                                            robot_file(robot), limits_file(robot), shift.x(),
                                            shift.y(), shift.z(), samples, turns)));
}

const Eigen::Vector3d kSeam(0.9, -0.1, 0.6);

std::vector<double> rail_samples() {
  std::vector<double> samples;
  for (int k = 0; k <= 6; ++k) samples.push_back(-1.5 + 0.5 * k);
  return samples;
}

/// Rail and arm, for every spin and every place of the rail.
std::vector<JointVector> postures(const Problem& with_rail, const Waypoint& waypoint,
                                  const Robot& arm, const InverseKinematics& ik) {
  std::vector<JointVector> result, branches, copies;
  for (const double rail : rail_samples()) {
    for (int k = 0; k < 6; ++k) {
      Pose tcp = waypoint.frame * Eigen::AngleAxisd(k * kPi / 3, Eigen::Vector3d::UnitZ());
      tcp.pretranslate(Eigen::Vector3d(0, -rail, -kCarriage));
      ik.solve(tcp, branches);
      for (const JointVector& branch : branches) {
        copies.clear();
        append_turns(arm, branch, with_rail.graph.turns, copies);
        for (const JointVector& q : copies) {
          JointVector whole(7);
          whole << rail, q;
          result.push_back(whole);
        }
      }
    }
  }
  return result;
}

/// Bellman over all edges.
double least_cost(const Problem& problem, const Eigen::VectorXd& weight) {
  RobotSource source;
  source.urdf = robot_file("kuka_kr5_arc");
  source.tip_link = "torch_tip";
  const auto arm = std::make_shared<const Robot>(load_robot(source));
  const auto ik = find_inverse_kinematics(arm);
  std::vector<JointVector> before;
  std::vector<double> cost;
  for (std::size_t i = 0; i < problem.task.waypoints.size(); ++i) {
    const auto rung = postures(problem, problem.task.waypoints[i], *arm, *ik.solver);
    std::vector<double> next(rung.size(), i == 0 ? 0 : kInfinity);
    for (std::size_t u = 0; u < before.size(); ++u) {
      const double dt = problem.task.waypoints[i].time - problem.task.waypoints[i - 1].time;
      for (std::size_t v = 0; v < rung.size(); ++v) {
        const JointVector step = (rung[v] - before[u]).cwiseAbs();
        if ((step.array() > dt * problem.robot->velocity_limits().array()).any()) continue;
        next[v] = std::min(next[v], cost[u] + step.dot(weight));
      }
    }
    before = rung;
    cost = std::move(next);
  }
  return *std::min_element(cost.begin(), cost.end());
}

TEST(RedundantGraph, FindsTheOptimumOfABruteForceProgramme) {
  const TemporaryFolder folder;
  for (const char* turns : {"principal", "all"}) {
    for (const double rail_weight : {0.2, 1.0, 30.0}) {
      Problem with_rail = problem(folder, "kuka_kr5_arc_rail", ", rail: 0.5", kSeam, turns);
      with_rail.cost.joint_weights = {rail_weight, 1, 1, 1, 1, 1, 1};
      Eigen::VectorXd weight = Eigen::VectorXd::Ones(7);
      weight[0] = rail_weight;
      const PlanResult result = plan_graph_only(with_rail);
      ASSERT_EQ(result.status, Status::solved);
      EXPECT_NEAR(result.graph.cost, least_cost(with_rail, weight), 1e-9)
          << turns << ", weight " << rail_weight;
    }
  }
}

TEST(RedundantGraph, OnARailThatStandsStillIsTheBestOfSixAxisPlans) {
  const TemporaryFolder folder;
  Problem with_rail = problem(folder, "kuka_kr5_arc_rail", ", rail: 0.5", kSeam, "all");
  Robot::Parts parts = with_rail.robot->parts();
  parts.joints[0].max_velocity = 1e-9;
  with_rail.robot = std::make_shared<const Robot>(parts);
  double best = kInfinity;
  int solved = 0;
  for (const double rail : rail_samples()) {
    const Problem six =
        problem(folder, "kuka_kr5_arc", "", kSeam - Eigen::Vector3d(0, rail, kCarriage), "all");
    const PlanResult result = plan_graph_only(six);
    if (result.status != Status::solved) continue;
    ++solved;
    best = std::min(best, result.graph.cost);
  }
  EXPECT_GT(solved, 1);
  EXPECT_LT(solved, 7);  // the ends of the rail are out of reach
  const PlanResult result = plan_graph_only(with_rail);
  ASSERT_EQ(result.status, Status::solved);
  EXPECT_NEAR(result.graph.cost, best, 1e-9);
}

TEST(RedundantGraph, DiagnosesNameTheJointsOfTheWholeChain) {
  const TemporaryFolder folder;
  const Problem too_far = problem(folder, "kuka_kr5_arc_rail", ", rail: 0.5",
                                  kSeam + Eigen::Vector3d(0, 3.2, 0), "all");
  const PlanResult out_of_reach = plan_graph_only(too_far);
  EXPECT_EQ(out_of_reach.status, Status::infeasible);
  ASSERT_FALSE(out_of_reach.diagnosis.empty());
  EXPECT_EQ(out_of_reach.diagnosis.front().reason, "out_of_reach");

  Problem tight = problem(folder, "kuka_kr5_arc_rail", ", rail: 0.5", kSeam, "all");
  Robot::Parts parts = tight.robot->parts();
  parts.joints[4].lower = 3.05;  // joint_a4, without any posture
  parts.joints[4].upper = 3.06;
  tight.robot = std::make_shared<const Robot>(parts);
  const PlanResult limited = plan_graph_only(tight);
  ASSERT_FALSE(limited.diagnosis.empty());
  ASSERT_TRUE(limited.diagnosis.front().counts.has_value());
  EXPECT_EQ(limited.diagnosis.front().counts->joint_limit.count("joint_a4"), 1U);
  EXPECT_EQ(limited.diagnosis.front().counts->joint_limit.count("rail"), 0U);
}

TEST(RedundantGraph, SparseAndCoarseToFineWorkWithIt) {
  const TemporaryFolder folder;
  Problem seam = problem(folder, "kuka_kr5_arc_rail", ", rail: 0.25", kSeam, "all");
  const PlanResult dense = plan_graph_only(seam);
  ASSERT_EQ(dense.status, Status::solved);
  seam.graph.coarse_to_fine = true;
  const PlanResult finer = plan_graph_only(seam);
  ASSERT_EQ(finer.status, Status::solved);
  EXPECT_LT(finer.graph.cost, dense.graph.cost);
  EXPECT_GT(finer.graph.grid_rounds, 0);
  seam.graph.coarse_to_fine = false;
  seam.graph.planner = Planner::sparse;
  const PlanResult sparse = plan_graph_only(seam);
  ASSERT_EQ(sparse.status, Status::solved);
}

TEST(RedundantGraph, TheSamplesOfAllTogetherAreLimited) {
  const TemporaryFolder folder;
  Problem seam = problem(folder, "kuka_kr5_arc_rail", ", rail: 0.1 mm", kSeam, "all");
  seam.graph.step[5] = 1e-2;
  EXPECT_THROW(plan_graph_only(seam), InvalidInput);
}

}  // namespace
}  // namespace wristwise
