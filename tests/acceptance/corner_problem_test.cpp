#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "io/result_file.hpp"
#include "temporary_folder.hpp"
#include "wristwise/error.hpp"
#include "wristwise/kinematics.hpp"
#include "wristwise/plan.hpp"

// A seam with a sharp corner, from rest to rest.
namespace wristwise {
namespace {

using test::file_text;
using test::replaced;
using test::TemporaryFolder;

std::string problem_text() {
  std::string text = file_text(std::string(WRISTWISE_SOURCE_DIR) + "/problems/corner_stop.yaml");
  while (text.find("../robots") != std::string::npos)
    text = replaced(text, "../robots", std::string(WRISTWISE_SOURCE_DIR) + "/robots");
  return text;
}

class CornerProblem : public testing::Test {
 protected:
  Problem load(const std::string& text) { return load_problem(folder_.write("corner.yaml", text)); }

  /// Through the files, as a user checks it.
  Verification check_written(const Problem& problem, const PlanResult& result) {
    write_result(folder_.path(), result, problem);
    const std::vector<std::string> joints = problem.robot->joint_names();
    return check(problem, read_trajectory(folder_.path() / "trajectory.csv", joints));
  }

  TemporaryFolder folder_;
};

void expect_passed(const Verification& verification) {
  EXPECT_TRUE(verification.passed) << testing::PrintToString(verification.failures);
}

/// The corner of the seam, by hand: 150 mm at 10 mm/s, and half of a ramp of 0.5 s.
TEST_F(CornerProblem, GraphOnlyStopsTurnsAndGoesOn) {
  const Problem problem = load(problem_text());
  const PlanResult result = plan_graph_only(problem);
  ASSERT_EQ(result.status, Status::solved);
  expect_passed(check_written(problem, result));
  const double arrives = 15.25, leaves = arrives + 15.0 / 8.0 * 3;
  const Eigen::Vector3d corner(0.95, 0.05, 0.2);
  int at_corner = 0;
  for (std::size_t i = 0; i < result.path.size(); ++i) {
    const double t = result.path.times[i];
    if (t < arrives - 1e-6 || t > leaves + 1e-6) continue;
    ++at_corner;
    EXPECT_LT((tcp_pose(*problem.robot, result.path.positions[i]).translation() - corner).norm(),
              1e-6);
  }
  EXPECT_EQ(at_corner, 10);
  const auto json = nlohmann::json::parse(file_text(folder_.path() / "result.json"));
  EXPECT_NEAR(json["run_in_s"], 2, 1e-12);
  EXPECT_NEAR(json["run_out_s"], 2, 1e-12);
  EXPECT_EQ(json["waypoints"], 68);
  // The runs are within 1 mm of the straight lines.
  const Pose last = tcp_pose(*problem.robot, result.path.positions.back());
  EXPECT_LT((last.translation() - Eigen::Vector3d(0.84, 0.05, 0.2)).norm(), 2e-3);
  const Pose first = tcp_pose(*problem.robot, result.path.positions.front());
  EXPECT_LT((first.translation() - Eigen::Vector3d(0.95, -0.11, 0.2)).norm(), 2e-3);
}

/// At rest at the corner and at both ends: all joints, to what the check demands.
TEST_F(CornerProblem, TwoStageIsASmoothMotionFromRestToRest) {
  const Problem problem = load(problem_text());
  const PlanResult result = plan(problem);
  ASSERT_EQ(result.status, Status::solved);
  ASSERT_FALSE(result.trajectory.empty());
  expect_passed(check_written(problem, result));
  const Trajectory& motion = result.trajectory;
  for (const double t : {motion.times().front(), motion.times().back()}) {
    EXPECT_LT(motion.evaluate(t, 1).cwiseAbs().maxCoeff(), 1e-6);
    EXPECT_LT(motion.evaluate(t, 2).cwiseAbs().maxCoeff(), 1e-6);
  }
  // The TCP follows the seam's clock: at weld speed but for the ramps, standing while it turns.
  const auto tcp = [&](double t) -> Eigen::Vector3d {
    return tcp_pose(*problem.robot, motion.evaluate(t)).translation();
  };
  const double h = 0.05;
  for (const double t : {1.0, 7.0, 14.0, 22.5, 28.0})
    EXPECT_NEAR((tcp(t + h) - tcp(t - h)).norm() / (2 * h), 0.01, 5e-4) << t;
  for (int i = 0; i < 56; ++i) {
    const double t = 15.25 + 0.1 * i;
    EXPECT_LT((tcp(t) - Eigen::Vector3d(0.95, 0.05, 0.2)).norm(), 2e-4) << t;
  }
}

TEST_F(CornerProblem, TwoStageRoundsOff) {
  const Problem problem = load(replaced(
      problem_text(), "corners: {stop: 0.5 s, turn_rate: 30 deg/s}", "corners: {blend: 8 mm}"));
  const PlanResult result = plan(problem);
  ASSERT_EQ(result.status, Status::solved);
  expect_passed(check_written(problem, result));
}

TEST_F(CornerProblem, GraphOnlyLiftsOffThePlate) {
  const Problem problem = load(replaced(problem_text(), "run_out: 10 mm",
                                        "run_out: {retract: [0, 0, -0.03], duration: 2 s}"));
  const PlanResult result = plan_graph_only(problem);
  ASSERT_EQ(result.status, Status::solved);
  expect_passed(check_written(problem, result));
  const Pose last = tcp_pose(*problem.robot, result.path.positions.back());
  EXPECT_LT((last.translation() - Eigen::Vector3d(0.85, 0.05, 0.23)).norm(), 2e-3);
}

TEST_F(CornerProblem, GraphOnlyRoundsOff) {
  const Problem problem = load(replaced(
      problem_text(), "corners: {stop: 0.5 s, turn_rate: 30 deg/s}", "corners: {blend: 8 mm}"));
  const PlanResult result = plan_graph_only(problem);
  ASSERT_EQ(result.status, Status::solved);
  expect_passed(check_written(problem, result));
  double nearest = 1;
  for (const JointVector& q : result.path.positions)
    nearest = std::min(
        nearest,
        (tcp_pose(*problem.robot, q).translation() - Eigen::Vector3d(0.95, 0.05, 0.2)).norm());
  EXPECT_GT(nearest, 0.001);
  EXPECT_LT(nearest, 0.004);
}

TEST_F(CornerProblem, GraphOnlySlowsDownWhereTheTorchMayKeepItsOrientation) {
  std::string text = replaced(problem_text(), "corners: {stop: 0.5 s, turn_rate: 30 deg/s}",
                              "corners: {slow: 0.2}");
  EXPECT_THROW(load(text), InvalidInput);  // 90 deg at once, with a spin of 30 deg
  text = replaced(text, "rz: 30 deg", "rz: free");
  const Problem problem = load(text);
  const PlanResult result = plan_graph_only(problem);
  ASSERT_EQ(result.status, Status::solved);
  expect_passed(check_written(problem, result));
}

}  // namespace
}  // namespace wristwise
