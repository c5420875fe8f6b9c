// Task B with the L-profile as one concave mesh, beside the same profile made of boxes.

#include <gtest/gtest.h>

#include <random>

#include "wristwise/wristwise.hpp"

namespace wristwise {
namespace {

Problem shipped(const std::string& name) {
  return load_problem(std::string(WRISTWISE_SOURCE_DIR) + "/problems/" + name + ".yaml", {false});
}

/// The robot against the profile alone.
double distance_from_profile(ClearanceChecker& checker, const JointVector& q) {
  checker.set_posture(q);
  const auto nearest = checker.nearest();
  return nearest ? nearest->distance : 1e9;
}

std::shared_ptr<const ClearanceModel> model_of(Problem problem) {
  Scene scene = problem.scene;
  scene.objects.pop_back();  // the plate
  scene.scope = CollisionScope::pairs;
  for (const SceneObject& object : scene.objects) {
    for (const char* link : {"torch", "link_3", "link_4", "link_6"}) {
      scene.pairs.emplace_back(link, object.name);
    }
  }
  return std::make_shared<const ClearanceModel>(problem.robot, scene);
}

TEST(MeshPart, IsWeldedInItsCornerInBothModes) {
  const Problem problem = shipped("task_b_mesh");
  EXPECT_TRUE(problem.scene.warnings.empty());
  EXPECT_EQ(problem.scene.objects[0].shapes.size(), 2U);
  for (const PlanResult& result : {plan(problem), plan_graph_only(problem)}) {
    EXPECT_EQ(result.status, Status::solved);
    const Verification verification =
        result.trajectory.empty() ? check(problem, result.path) : check(problem, result.trajectory);
    EXPECT_TRUE(verification.passed);
    // The boxes are another model of the same part: what is clear of the mesh is clear of them.
    const Problem boxes = shipped("task_b_l_profile");
    EXPECT_TRUE(
        (result.trajectory.empty() ? check(boxes, result.path) : check(boxes, result.trajectory))
            .passed);
  }
}

TEST(MeshPart, ClearanceIsThatOfBoxesWithinTheErrorAndNeverMore) {
  MeshOptions options;
  options.convex_error = 0.002;
  const double error = *load_mesh(std::string(WRISTWISE_SOURCE_DIR) + "/problems/l_profile.stl",
                                  {0.001, 0.001, 0.001}, options)
                            .error;
  ClearanceChecker mesh(model_of(shipped("task_b_mesh")));
  ClearanceChecker boxes(model_of(shipped("task_b_l_profile")));
  const JointVector lower = mesh.model().robot().lower_limits().cwiseMax(-3.0);
  const JointVector upper = mesh.model().robot().upper_limits().cwiseMin(3.0);
  std::mt19937 random(81);
  int touching = 0, clear = 0;
  for (int sample = 0; sample < 3000; ++sample) {
    JointVector q(lower.size());
    for (int j = 0; j < q.size(); ++j) {
      q[j] = std::uniform_real_distribution<double>(lower[j], upper[j])(random);
    }
    if (sample % 2 == 0)
      q.head<3>() = Eigen::Vector3d(0.2, -1.2, 1.6)
                        .cwiseProduct(Eigen::Vector3d::Ones() + 0.3 * q.head<3>() / 3);
    const double by_mesh = distance_from_profile(mesh, q);
    const double by_boxes = distance_from_profile(boxes, q);
    if (by_boxes > 1e-5) {
      ++clear;
      EXPECT_LE(by_mesh, by_boxes + 2e-6);
      EXPECT_GE(by_mesh, by_boxes - error - 2e-6);
    } else {
      touching += by_boxes < -1e-5;
      EXPECT_LE(by_mesh, 2e-5);
    }
  }
  EXPECT_GT(touching, 50);
  EXPECT_GT(clear, 500);
}

TEST(MeshPart, FilledCannotBeWelded) {
  Problem problem = shipped("task_b_mesh");
  SceneObject& profile = problem.scene.objects[0];
  const MeshBody filled = load_mesh(std::string(WRISTWISE_SOURCE_DIR) + "/problems/l_profile.stl",
                                    {0.001, 0.001, 0.001});
  const Pose pose = profile.shapes[0].pose;
  profile.shapes = {{filled.pieces.at(0), pose}};
  problem.graph.try_relaxations = false;
  EXPECT_EQ(plan_graph_only(problem).status, Status::infeasible);
}

}  // namespace
}  // namespace wristwise
