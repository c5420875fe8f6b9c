// speed_policy: slow beside other things: obstacles, a run-in and run-out, moves in joint space.
// Whatever is slowed is checked through its file, as a user does, and against limits by sampling.

#include <gtest/gtest.h>

#include <cmath>

#include "temporary_folder.hpp"
#include "wristwise/wristwise.hpp"

namespace wristwise {
namespace {

using test::file_text;
using test::replaced;
using test::TemporaryFolder;

const std::string kRoot = WRISTWISE_SOURCE_DIR;

/// The row of jaws that a torch can only weave through slower.
Problem weave(const TemporaryFolder& folder) {
  std::string text = file_text(kRoot + "/problems/two_ways_round.yaml");
  while (text.find("../robots") != std::string::npos)
    text = replaced(text, "../robots", kRoot + "/robots");
  text = replaced(text, "  speed: 0.15\n", "  speed: 0.15\n  speed_policy: slow\n");
  return load_problem(folder.write("weave.yaml", text));
}

/// Past the wrist singularity, torch held straight, far too fast there for joint 4.
Problem singular(const TemporaryFolder& folder, const std::string& more_path,
                 const std::string& before = "", const std::string& after = "") {
  const std::string text =
      "robot:\n  urdf: " + kRoot + "/robots/kuka_kr5_arc/kuka_kr5_arc_round_torch.urdf\n" +
      "  base_link: base_link\n  tip_link: torch_tip\n  limits: " + kRoot +
      "/robots/kuka_kr5_arc/joint_limits.yaml\n" +
      "scene: {collision: off}\npath:\n  waypoints: 60\n  speed_policy: slow\n" +
      "  tolerance: {rx: 0.1 deg, ry: 0.1 deg, rz: 0.1 deg}\n  speed: 0.2\n" + more_path +
      "  segments:\n" + before +
      "    - line:\n"
      "        from: {xyz: [0.820654462064, -0.25, 0.273565462757], rpy: [0, 180 deg, 0]}\n"
      "        to: {xyz: [0.820654462064, 0.25, 0.273565462757], rpy: [0, 180 deg, 0]}\n" +
      after + "refine: {smoothing_time: 0.5}\n";
  return load_problem(folder.write("singular.yaml", text));
}

void expect_slowed_and_sound(const Problem& problem, const PlanResult& result,
                             const TemporaryFolder& folder) {
  ASSERT_EQ(result.status, Status::solved)
      << (result.diagnosis.empty() ? "" : result.diagnosis.front().detail);
  ASSERT_FALSE(result.seam_time.empty());
  ASSERT_FALSE(result.slowed.empty());
  const Trajectory& motion = result.trajectory;
  const double start = motion.times().front(), end = motion.times().back();
  for (double t = start; t <= end; t += 1e-3) {
    const auto ratio = [&](int k, const JointVector& limits) {
      return motion.evaluate(t, k).cwiseAbs().cwiseQuotient(limits).maxCoeff();
    };
    EXPECT_LE(ratio(1, problem.robot->velocity_limits()), 1);
    EXPECT_LE(ratio(2, problem.robot->acceleration_limits()), 1);
    EXPECT_LE(ratio(3, problem.robot->jerk_limits()), 1);
    EXPECT_LE(result.seam_time.evaluate(t, 1)[0], 1 + 1e-6);
  }
  const std::vector<std::string> names = problem.robot->joint_names();
  write_trajectory(folder.path() / "trajectory.csv", names, motion,
                   SeamColumns(problem.task.retimed(result.seam_time)));
  PlanOptions dense;
  dense.verification.samples_per_interval = 50;
  const Verification verification =
      check(problem, read_trajectory(folder.path() / "trajectory.csv", names), dense);
  EXPECT_TRUE(verification.passed) << testing::PrintToString(verification.failures);
}

/// The TCP is where the law says, from the joint values alone; the weld starts and ends where it
/// should.
void expect_on_seam(const Problem& problem, const PlanResult& result) {
  const Seam slowed = problem.task.seam.retimed(result.seam_time);
  const double first = slowed.real_time(0), last = slowed.real_time(2.5);
  EXPECT_GT(last - first, 2.5);
  for (int i = 0; i <= 500; ++i) {
    const double t = first + (last - first) * i / 500;
    const Pose tcp = tcp_pose(*problem.robot, result.trajectory.evaluate(t));
    const double nominal = result.seam_time.evaluate(t)[0];
    const Eigen::Vector3d due(0.820654462064, -0.25 + 0.2 * nominal, 0.273565462757);
    EXPECT_LT((tcp.translation() - due).norm(), 2e-4);
  }
}

TEST(SlowedWeld, WeavesBetweenObstacles) {
  const TemporaryFolder folder;
  Problem problem = weave(folder);
  problem.graph.spare_seeds = 0;
  const PlanResult result = plan(problem);
  expect_slowed_and_sound(problem, result, folder);
  ASSERT_TRUE(result.verification.clearance_bound);
  EXPECT_GE(*result.verification.clearance_bound, 0.002 - 5e-5);
  // Slowed where the jaws are, from 1.4 to 2.6 s, and not for the whole seam.
  const Trajectory& law = result.seam_time;
  const double end = law.times().back();
  EXPECT_LT(end, 4 * 1.6);
  EXPECT_GT(law.evaluate(0.1, 1)[0], 0.99);
  EXPECT_GT(law.evaluate(end - 0.1, 1)[0], 0.95);
}

/// A way round that needs not be slowed comes before one that must.
TEST(SlowedWeld, IsNotSlowedWhereAnotherSeedNeedsNot) {
  const TemporaryFolder folder;
  const Problem problem = weave(folder);
  const PlanResult result = plan(problem);
  EXPECT_EQ(result.status, Status::solved);
  EXPECT_TRUE(result.seam_time.empty());
  EXPECT_TRUE(result.slowed.empty());
  EXPECT_NEAR(result.trajectory.times().back(), 4, 1e-9);
}

TEST(SlowedWeld, StartsAndEndsAtRestWithRuns) {
  const TemporaryFolder folder;
  const Problem problem = singular(folder, "  run_in: 100 mm\n  run_out: 100 mm\n");
  const PlanResult result = plan(problem);
  expect_slowed_and_sound(problem, result, folder);
  expect_on_seam(problem, result);
  const Trajectory& motion = result.trajectory;
  for (const double t : {motion.times().front(), motion.times().back()}) {
    EXPECT_LT(motion.evaluate(t, 1).cwiseAbs().maxCoeff(), 1e-6);
    EXPECT_LT(motion.evaluate(t, 2).cwiseAbs().maxCoeff(), 1e-6);
  }
}

TEST(SlowedWeld, ComesFromAJointWaypointAndGoesToOne) {
  const TemporaryFolder folder;
  const PlanResult seam = plan(singular(folder, ""));
  ASSERT_EQ(seam.status, Status::solved);
  const auto joints = [](const JointVector& q) {
    std::string text = "    - joints: [[";
    for (Eigen::Index j = 0; j < q.size(); ++j)
      text += (j > 0 ? ", " : "") + std::to_string(q[j] + (j == 1 ? -0.1 : 0.02));
    return text + "]]\n";
  };
  const JointVector first = seam.path.positions.front(), last = seam.path.positions.back();
  const Problem problem = singular(folder, "", joints(first), joints(last));
  const PlanResult result = plan(problem);
  expect_slowed_and_sound(problem, result, folder);
  const Trajectory& motion = result.trajectory;
  const JointVector offset = (JointVector(6) << 0.02, -0.1, 0.02, 0.02, 0.02, 0.02).finished();
  EXPECT_LT((motion.evaluate(motion.times().front()) - first - offset).cwiseAbs().maxCoeff(), 2e-6);
  EXPECT_LT((motion.evaluate(motion.times().back()) - last - offset).cwiseAbs().maxCoeff(), 2e-6);
}

}  // namespace
}  // namespace wristwise
