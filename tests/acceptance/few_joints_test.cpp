// Chains of fewer than six joints from the problem to the check: the paper's planar arm (section
// II), and five axes that hold a torch at a spin they can't choose.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>

#include "kuka_kr5_arc.hpp"
#include "wristwise/kinematics.hpp"
#include "wristwise/plan.hpp"

namespace wristwise {
namespace {

Problem planar() {
  return load_problem(std::filesystem::path(WRISTWISE_SOURCE_DIR) / "problems" / "planar_3r.yaml");
}

/// Largest deviation of a coordinate along a path.
double largest(const Problem& problem, const JointPath& path, int coordinate) {
  double most = 0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Waypoint& waypoint = problem.task.waypoints[i];
    const Pose tcp = tcp_pose(*problem.robot, path.positions[i]);
    most = std::max(most, std::abs(deviation(waypoint.tolerance, waypoint.frame, tcp)[coordinate]));
  }
  return most;
}

TEST(FewJoints, ThePlanarArmIsPlannedInBothModes) {
  const Problem problem = planar();
  for (const PlanResult& result : {plan(problem), plan_graph_only(problem)}) {
    EXPECT_EQ(result.status, Status::solved);
    EXPECT_TRUE(result.verification.passed);
    EXPECT_NE(result.inverse_kinematics.find("numeric"), std::string::npos);
    for (const int out_of_plane : {2, 3, 4})
      EXPECT_LT(largest(problem, result.path, out_of_plane), 1e-12);
  }
}

TEST(FewJoints, FreedomOfOrientationIsPreferredToFreedomOfPosition) {
  const Problem preferring = planar();
  Problem indifferent = planar();
  indifferent.cost.position_graph = indifferent.cost.position_refine = 0;
  const PlanResult with = plan(preferring), without = plan(indifferent);
  ASSERT_EQ(with.status, Status::solved);
  ASSERT_EQ(without.status, Status::solved);
  EXPECT_LT(largest(preferring, with.path, 0), 0.5 * largest(indifferent, without.path, 0));
  EXPECT_GT(largest(preferring, with.path, 5), 0.2);
  const PlanResult graph = plan_graph_only(preferring), plain = plan_graph_only(indifferent);
  EXPECT_LT(largest(preferring, graph.path, 0), 1e-9);
  EXPECT_GT(largest(indifferent, plain.path, 0), 0.009);
}

TEST(FewJoints, PositionIsUsedWhereTheReachEnds) {
  Problem problem = planar();
  const auto shift = [&](double x, double width) {
    std::vector<SeamPiece> pieces = problem.task.seam.pieces();
    for (SeamPiece& piece : pieces) {
      piece.from.translation() << x, -0.05, 0;
      piece.to.translation() << x, 0.05, 0;
    }
    problem.task.seam = Seam(pieces);
    for (Waypoint& waypoint : problem.task.waypoints) {
      waypoint.frame = problem.task.seam.frame_at(waypoint.time);
      waypoint.tolerance.lower[0] = -width;
      waypoint.tolerance.upper[0] = width;
    }
  };
  problem.graph.try_relaxations = false;
  shift(1.11, 0);  // the arm is 1.1 m long
  const PlanResult without = plan(problem);
  EXPECT_EQ(without.status, Status::infeasible);
  ASSERT_FALSE(without.diagnosis.empty());
  EXPECT_EQ(without.diagnosis.front().reason, "out_of_reach");
  shift(1.11, 0.03);
  const PlanResult with = plan(problem);
  EXPECT_EQ(with.status, Status::solved);
  EXPECT_GT(largest(problem, with.path, 0), 0.01);
}

TEST(FewJoints, WhatIsOutOfThePlaneIsOutOfReach) {
  Problem problem = planar();
  problem.graph.try_relaxations = false;
  problem.task.waypoints[7].frame.translation().z() = 1e-6;
  const PlanResult result = plan_graph_only(problem);
  EXPECT_EQ(result.status, Status::infeasible);
  ASSERT_FALSE(result.diagnosis.empty());
  EXPECT_EQ(result.diagnosis.front().waypoint, 7U);
}

/// The arm of the paper without its last joint: the spin follows from the rest and is on no grid.
TEST(FewJoints, FiveAxesFindTheSpinThatTheyHave) {
  Problem problem =
      load_problem(std::filesystem::path(WRISTWISE_SOURCE_DIR) / "problems" / "known_graph.yaml");
  Robot::Parts parts;
  parts.name = "five axes";
  parts.joints = problem.robot->joints();
  Pose tcp = parts.joints[5].origin * problem.robot->tcp();
  parts.joints.pop_back();
  parts.tcp = tcp;
  problem.robot = std::make_shared<const Robot>(parts);
  problem.graph.step[5] = 0.2;
  problem.graph.max_stray = 0.05;
  for (const PlanResult& result : {plan_graph_only(problem), plan(problem)}) {
    EXPECT_EQ(result.status, Status::solved);
    EXPECT_TRUE(result.verification.passed);
    EXPECT_EQ(result.path.size(), problem.task.waypoints.size());
  }
}

}  // namespace
}  // namespace wristwise
