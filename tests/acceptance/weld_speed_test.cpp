// A seam that passes the wrist singularity within 1 degree with the torch held straight, many times
// faster than joint 4 can follow: 0.55 rad/s of it at 10 mm/s.

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <fstream>
#include <regex>

#include "temporary_folder.hpp"
#include "wristwise/wristwise.hpp"

namespace wristwise {
namespace {

using test::TemporaryFolder;

const std::string kRobot = std::string(WRISTWISE_SOURCE_DIR) + "/robots/kuka_kr5_arc/";

std::string seam_text(double speed, const std::string& more_path, const std::string& more = "") {
  return "robot:\n  urdf: " + kRobot + "kuka_kr5_arc_round_torch.urdf\n" +
         "  base_link: base_link\n  tip_link: torch_tip\n  limits: " + kRobot +
         "joint_limits.yaml\n" + R"(scene: {collision: off}
path:
  waypoints: 120
  segments:
    - line:
        from: {xyz: [0.820654462064, -0.25, 0.273565462757], rpy: [0, 180 deg, 0]}
        to: {xyz: [0.820654462064, 0.25, 0.273565462757], rpy: [0, 180 deg, 0]}
  tolerance: {rx: 0.1 deg, ry: 0.1 deg, rz: 0.1 deg}
  speed: )" +
         std::to_string(speed) + "\n" + more_path +
         "graph: {samples: {rx: 0.1 deg, ry: 0.1 deg, rz: 0.1 deg}}\n" + more;
}

Problem seam_problem(double speed, const std::string& more_path = "",
                     const std::string& more = "") {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "problem.yaml";
  std::ofstream(file) << seam_text(speed, more_path, more);
  return load_problem(file);
}

double suggested_speed(const Diagnosis& diagnosis) {
  std::smatch match;
  const std::regex pattern("is ([0-9.e-]+) m/s");
  return std::regex_search(diagnosis.suggestion, match, pattern) ? std::stod(match[1]) : 0;
}

constexpr double kSpeed = 0.2;

TEST(WeldSpeed, ThatCantBeHeldIsInfeasibleAndTheSpeedThatWorksIsNamed) {
  const PlanResult result = plan(seam_problem(kSpeed));
  EXPECT_EQ(result.status, Status::infeasible);
  ASSERT_FALSE(result.diagnosis.empty());
  const Diagnosis& diagnosis = result.diagnosis.front();
  EXPECT_EQ(diagnosis.reason, "infeasible_at_this_speed");
  EXPECT_NE(diagnosis.detail.find("joint_a4"), std::string::npos) << diagnosis.detail;
  ASSERT_TRUE(diagnosis.waypoint);
  EXPECT_NEAR(static_cast<double>(*diagnosis.waypoint), 60, 15);
  // What is shown meets everything else.
  EXPECT_GT(result.verification.acceleration_ratio, 1);
  EXPECT_LE(result.verification.tolerance_excess.maxCoeff(), 1e-6);

  const double speed = suggested_speed(diagnosis);
  ASSERT_GT(speed, 0.02) << diagnosis.suggestion;
  ASSERT_LT(speed, kSpeed);
  EXPECT_EQ(plan(seam_problem(speed)).status, Status::solved);
  const PlanResult faster = plan(seam_problem(1.05 * speed, "", "refine: {try_speeds: false}\n"));
  EXPECT_EQ(faster.status, Status::infeasible);
}

TEST(WeldSpeed, IsHeldButForTheSingularity) {
  const Problem problem = seam_problem(kSpeed, "  speed_policy: slow\n");
  const PlanResult result = plan(problem);
  ASSERT_EQ(result.status, Status::solved);
  EXPECT_TRUE(result.verification.passed);
  ASSERT_FALSE(result.seam_time.empty());

  const Trajectory& law = result.seam_time;
  const double end = law.times().back();
  double at_full_speed = 0, slowest = 1, slowest_y = 1;
  constexpr int kSamples = 5000;
  for (int i = 0; i < kSamples; ++i) {
    const double t = end * (i + 0.5) / kSamples;
    const double speed = law.evaluate(t, 1)[0], nominal = law.evaluate(t)[0];
    EXPECT_LE(speed, 1 + 1e-6);
    if (speed > 0.999) at_full_speed += speed * end / kSamples;
    if (speed < slowest) {
      slowest = speed;
      slowest_y = -0.25 + kSpeed * nominal;
    }
    // From the joint values alone: the TCP is where the law says.
    const Pose tcp = tcp_pose(*problem.robot, result.trajectory.evaluate(t));
    const Eigen::Vector3d due(0.820654462064, -0.25 + kSpeed * nominal, 0.273565462757);
    EXPECT_LT((tcp.translation() - due).norm(), 2e-4);
  }
  EXPECT_GT(at_full_speed, 0.55 * 0.5 / kSpeed);
  EXPECT_NEAR(slowest_y, 0, 0.03);

  ASSERT_EQ(result.slowed.size(), 1U);
  EXPECT_EQ(result.slowed[0].joint, 3);
  EXPECT_NEAR(result.slowed[0].least_ratio, slowest, 1e-3);
  EXPECT_GT(result.slowed[0].from, 0.5);
  EXPECT_LT(result.slowed[0].to, end - 0.5);

  // Faster than the whole seam at the speed of its worst place.
  EXPECT_LT(end, 0.75 * 0.5 / (kSpeed * slowest));
  const JointVector velocity = problem.robot->velocity_limits(),
                    acceleration = problem.robot->acceleration_limits(),
                    jerk = problem.robot->jerk_limits();
  for (double t = 0; t < end; t += 1e-4) {
    EXPECT_LE(result.trajectory.evaluate(t, 1).cwiseAbs().cwiseQuotient(velocity).maxCoeff(), 1);
    EXPECT_LE(result.trajectory.evaluate(t, 2).cwiseAbs().cwiseQuotient(acceleration).maxCoeff(),
              1);
    EXPECT_LE(result.trajectory.evaluate(t, 3).cwiseAbs().cwiseQuotient(jerk).maxCoeff(), 1);
  }
}

/// The slower law is on top of the problem's own: a stop at a corner stays, nothing gets faster,
/// and the file that is written passes the check.
TEST(WeldSpeed, IsSlowedBesideACornerThatStops) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "problem.yaml";
  std::string text = seam_text(kSpeed, "  speed_policy: slow\n  corners: stop\n");
  const std::string end =
      "to: {xyz: [0.820654462064, 0.25, 0.273565462757], rpy: [0, 180 deg, 0]}\n";
  const std::string corner =
      "{xyz: [0.820654462064, 0.15, 0.273565462757], rpy: [0, 180 deg, 0]}\n";
  text.replace(
      text.find(end), end.size(),
      "to: " + corner + "    - line:\n        from: " + corner +
          "        to: {xyz: [0.900654462064, 0.15, 0.273565462757], rpy: [0, 180 deg, 0]}\n");
  std::ofstream(file) << text;
  const Problem problem = load_problem(file);
  const PlanResult result = plan(problem);
  ASSERT_EQ(result.status, Status::solved);
  ASSERT_FALSE(result.slowed.empty());

  const Seam& own = problem.task.seam;
  const Seam slowed = own.retimed(result.seam_time);
  for (double nominal = own.pieces().front().start_time; nominal < own.pieces().back().end_time;
       nominal += 0.003) {
    EXPECT_LE(slowed.speed_ratio(slowed.real_time(nominal)),
              own.speed_ratio(own.real_time(nominal)) + 1e-3);
  }
  const double at_corner = own.pieces().front().end_time;
  EXPECT_NEAR(slowed.speed_ratio(slowed.real_time(at_corner)), 0, 1e-3);

  const std::vector<std::string> names = problem.robot->joint_names();
  write_trajectory(folder.path() / "trajectory.csv", names, result.trajectory,
                   SeamColumns(problem.task.retimed(result.seam_time)));
  EXPECT_TRUE(check(problem, read_trajectory(folder.path() / "trajectory.csv", names)).passed);
}

/// 100 times: no move of the grid is slow enough, in stage 1 already.
TEST(WeldSpeed, OfAHundredTimesIsSlowedToo) {
  const PlanResult result = plan(seam_problem(1, "  speed_policy: slow\n"));
  EXPECT_EQ(result.status, Status::solved);
  ASSERT_FALSE(result.slowed.empty());
  double least = 1;
  for (const SlowedStretch& stretch : result.slowed) least = std::min(least, stretch.least_ratio);
  EXPECT_LT(least, 0.2);
  EXPECT_GT(least, 0.05);
}

TEST(WeldSpeed, ThatCanBeHeldIsHeld) {
  const PlanResult result = plan(seam_problem(0.05, "  speed_policy: slow\n"));
  EXPECT_EQ(result.status, Status::solved);
  EXPECT_TRUE(result.seam_time.empty());
  EXPECT_TRUE(result.slowed.empty());
}

TEST(WeldSpeed, OfAPathToSmoothIsNamedAsWell) {
  Problem problem = seam_problem(kSpeed);
  problem.refine.try_speeds = false;
  const PlanResult planned = plan(problem);
  ASSERT_FALSE(planned.seeds.empty());
  JointPath seed = planned.seeds.front().path;
  problem.refine.try_speeds = true;
  const PlanResult result = smooth(problem, seed);
  EXPECT_EQ(result.status, Status::infeasible);
  EXPECT_EQ(result.diagnosis.front().reason, "infeasible_at_this_speed");
  const double speed = suggested_speed(result.diagnosis.front());
  ASSERT_GT(speed, 0.02);
  for (double& t : seed.times) t *= kSpeed / speed;
  EXPECT_EQ(smooth(seam_problem(speed), seed).status, Status::solved);
}

TEST(WeldSpeed, IsNotWhatIsInTheWayOfAPostureOutOfReach) {
  Problem problem = seam_problem(kSpeed);
  SeamPiece piece = problem.task.seam.pieces().front();
  piece.from.translation().x() += 3;
  piece.to.translation().x() += 3;
  problem.task.seam = Seam({piece});
  for (Waypoint& waypoint : problem.task.waypoints) waypoint.frame.translation().x() += 3;
  problem.graph.try_relaxations = false;
  const PlanResult result = plan(problem);
  EXPECT_EQ(result.status, Status::infeasible);
  EXPECT_EQ(result.diagnosis.front().reason, "out_of_reach");
}

TEST(WeldSpeed, TrialsCanBeCancelled) {
  std::atomic<bool> cancel{false};
  PlanOptions options;
  options.monitor.cancel = &cancel;
  // The check of the motion without limits comes before the trials.
  options.monitor.progress = [&](const std::string& stage, double fraction) {
    if (stage == "verify" && fraction == 1) cancel = true;
  };
  const PlanResult result = plan(seam_problem(kSpeed), options);
  EXPECT_EQ(result.status, Status::interrupted);
}

}  // namespace
}  // namespace wristwise
