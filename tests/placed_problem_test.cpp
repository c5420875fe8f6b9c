// A problem with its part, or its robot, elsewhere, against the file with other numbers in it.

#include "placement/placed_problem.hpp"

#include <gtest/gtest.h>

#include <random>

#include "invalid_input.hpp"
#include "io/frame_keys.hpp"
#include "io/placed_problem_file.hpp"
#include "placement_example.hpp"

namespace wristwise {
namespace {

using test::invalid_input;
using test::placement_text;
using test::replaced;
using test::says;

/// Every kind of segment, corner and run in one seam.
constexpr const char* kSegments = R"(
    - line: {from: {xyz: [0, -0.06, 0], rpy: [0, 135 deg, 0]}, to: {xyz: [0, 0, 0], rpy: [0, 135 deg, 0]}}
    - arc: {from: {xyz: [0, 0, 0], rpy: [0, 135 deg, 0]}, center: [0.05, 0, 0], axis: [0, 0, -1], angle: 90 deg}
    - poses: seam.csv
)";
constexpr const char* kPoses =
    "x,y,z,qw,qx,qy,qz\n0.05,0.05,0,0.27059805,-0.65328148,0.65328148,0.27059805\n"
    "0.10,0.05,0,0.27059805,-0.65328148,0.65328148,0.27059805\n";

class PlacedProblemTest : public testing::Test {
 protected:
  PlacedProblemTest() { folder_.write("seam.csv", kPoses); }

  /// The part turned by (rx, ry, rz), given as `rpy` in the file, at xyz.
  std::string text(const std::string& placement, const std::string& frame) {
    std::string result = placement_text(placement);
    const std::size_t start = result.find("\n    - line:");
    result.replace(start, result.find("  tolerance") - start - 1, std::string(kSegments));
    result = replaced(result, "{xyz: [1.0, 0, 0.8]}", frame);
    result = replaced(result, "waypoints: 7", "waypoints: 60");
    return replaced(result, "  speed: 0.02\n",
                    "  speed: 0.02\n  corners: stop\n  run_in: {approach: [0, 0, -0.02]}\n");
  }

  PlacementRequest request(const std::string& text) {
    return load_placement(folder_.write("p.yaml", text));
  }

  test::TemporaryFolder folder_;
};

void expect_same_task(const Task& a, const Task& b) {
  ASSERT_EQ(a.waypoints.size(), b.waypoints.size());
  for (std::size_t i = 0; i < a.waypoints.size(); ++i) {
    EXPECT_NEAR(a.waypoints[i].time, b.waypoints[i].time, 1e-9);
    EXPECT_TRUE(a.waypoints[i].frame.isApprox(b.waypoints[i].frame, 1e-9)) << i;
    EXPECT_EQ(a.waypoints[i].joints.has_value(), b.waypoints[i].joints.has_value());
  }
  const double start = a.seam.start_time(), end = a.seam.end_time();
  EXPECT_NEAR(end, b.seam.end_time(), 1e-9);
  for (int k = 0; k <= 40; ++k) {
    const double t = start + k * (end - start) / 40;
    EXPECT_TRUE(a.seam.frame_at(t).isApprox(b.seam.frame_at(t), 1e-7)) << t;
  }
  EXPECT_EQ(a.rest_at_start, b.rest_at_start);
  EXPECT_EQ(a.between_position, b.between_position);
  EXPECT_EQ(a.speed_policy, b.speed_policy);
}

TEST_F(PlacedProblemTest, APartElsewhereIsTheFileWithAnotherFrame) {
  const std::string here = "{xyz: [1.0, 0, 0.8]}";
  const std::string there = "{xyz: [1.03, -0.05, 0.81], rpy: [0.1, -0.2, 0.3]}";
  Offset offset;
  offset << 0.03, -0.05, 0.01, 0.1, -0.2, 0.3;
  const PlacedProblem moved = placed(request(text("{with: [plate]}", here)), offset);
  const Problem expected = request(text("{with: [plate]}", there)).problem;
  expect_same_task(moved.problem.task, expected.task);
  EXPECT_TRUE(
      moved.part_frame.isApprox(pose_from_xyz_rpy({1.03, -0.05, 0.81}, {0.1, -0.2, 0.3}), 1e-12));
}

TEST_F(PlacedProblemTest, TurnsAreAboutTheAxesOfTheBaseThroughThePart) {
  const PlacementRequest turned =
      request(text("{with: [plate]}", "{xyz: [1.0, 0, 0.8], rpy: [0.4, 0, 0]}"));
  Offset offset = Offset::Zero();
  offset[5] = 0.5;
  const Pose expected = Eigen::Translation3d(1, 0, 0.8) *
                        Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitZ()) *
                        Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitX());
  EXPECT_TRUE(placed(turned, offset).part_frame.isApprox(expected, 1e-12));
}

TEST_F(PlacedProblemTest, ObjectsThatAreNamedMoveWithThePart) {
  const PlacementRequest given = request(text("{with: [plate]}", "{xyz: [1.0, 0, 0.8]}"));
  Offset offset;
  offset << 0.03, -0.05, 0.01, 0.1, -0.2, 0.3;
  const PlacedProblem there = placed(given, offset);
  EXPECT_EQ(there.moved, std::vector<std::string>{"plate"});
  const Pose plate = given.problem.scene.objects[0].shapes[0].pose;
  const Pose moved = there.problem.scene.objects[0].shapes[0].pose;
  EXPECT_TRUE(
      (given.part_frame.inverse() * plate).isApprox(there.part_frame.inverse() * moved, 1e-12));
  EXPECT_TRUE(there.problem.scene.objects[1].shapes[0].pose.isApprox(
      given.problem.scene.objects[1].shapes[0].pose, 0));
}

/// The robot moved by D sees what it sees when all else is moved by the inverse of D.
TEST_F(PlacedProblemTest, ARobotElsewhereIsEverythingElseMovedBack) {
  const PlacementRequest given =
      request(text("{move: robot, with: [pillar]}", "{xyz: [1.0, 0, 0.8]}"));
  Offset offset;
  offset << 0.1, -0.2, 0.05, 0.02, 0.03, 0.7;
  const Pose base = pose_from_xyz_rpy({0.1, -0.2, 0.05}, {0.02, 0.03, 0.7});
  const PlacedProblem there = placed(given, offset);
  EXPECT_EQ(there.moved, std::vector<std::string>{"plate"});
  EXPECT_TRUE((base * there.part_frame).isApprox(given.part_frame, 1e-12));
  for (std::size_t i = 0; i < given.problem.task.waypoints.size(); ++i)
    EXPECT_TRUE((base * there.problem.task.waypoints[i].frame)
                    .isApprox(given.problem.task.waypoints[i].frame, 1e-9));
  EXPECT_TRUE((base * there.problem.scene.objects[0].shapes[0].pose)
                  .isApprox(given.problem.scene.objects[0].shapes[0].pose, 1e-12));
  EXPECT_TRUE(there.problem.scene.objects[1].shapes[0].pose.isApprox(
      given.problem.scene.objects[1].shapes[0].pose, 0));  // goes with the robot
}

/// Moves to joint waypoints get the time that they need from where the part then is.
TEST_F(PlacedProblemTest, JointWaypointsStayAndTheirMovesAreTimedAnew) {
  const std::string with_home =
      replaced(placement_text("{with: [plate]}"),
               "    - line:", "    - joints: [[0, -1.5, 1.5, 0, 0.5, 0]]\n    - line:");
  const PlacementRequest given = request(with_home);
  Offset offset = Offset::Zero();
  offset[1] = 0.3;
  const PlacedProblem there = placed(given, offset);
  expect_same_task(
      there.problem.task,
      request(replaced(with_home, "xyz: [1.0, 0, 0.8]", "xyz: [1.0, 0.3, 0.8]")).problem.task);
  EXPECT_TRUE(there.problem.task.waypoints[0].joints.has_value());
  EXPECT_NE(there.problem.task.waypoints[1].time, given.problem.task.waypoints[1].time);
}

TEST_F(PlacedProblemTest, TheFileThatIsWrittenLeadsToTheSameProblemFromElsewhere) {
  const PlacementRequest given = request(text("{with: [plate]}", "{xyz: [1.0, 0, 0.8]}"));
  Offset offset;
  offset << 0.03, -0.05, 0.01, 0.1, -0.2, 0.3;
  const PlacedProblem there = placed(given, offset);
  const auto folder = folder_.path() / "deep" / "er";
  std::filesystem::create_directories(folder);
  const std::string written = placed_problem_text(folder_.path() / "p.yaml", there, folder);
  const auto file = folder_.write("deep/er/placed.yaml", written);
  EXPECT_TRUE(says(written, "../../seam.csv")) << written;
  const Problem read = load_problem(file);
  expect_same_task(read.task, there.problem.task);
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_TRUE(read.scene.objects[i].shapes[0].pose.isApprox(
        there.problem.scene.objects[i].shapes[0].pose, 1e-8));
  EXPECT_EQ(read.scene.clearance, given.problem.scene.clearance);
  EXPECT_EQ(read.graph.step, given.problem.graph.step);
  EXPECT_TRUE(says(invalid_input([&] { load_placement(file); }), "'placement' is missing"));
}

TEST(FrameKeys, AreTheInverseOfTheReader) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-3, 3);
  for (int k = 0; k < 500; ++k) {
    const Pose pose = pose_from_xyz_rpy({any(random), any(random), any(random)},
                                        {any(random), any(random), any(random)});
    const FrameKeys keys = frame_keys(pose);
    EXPECT_TRUE(pose_from_xyz_rpy(keys.xyz, keys.rpy).isApprox(pose, 1e-8));
  }
  const Pose upright = pose_from_xyz_rpy({0.1, 0, 0}, {0, 1.5707963267948966, 0});
  const FrameKeys keys = frame_keys(upright);
  EXPECT_TRUE(pose_from_xyz_rpy(keys.xyz, keys.rpy).isApprox(upright, 1e-8));
  EXPECT_EQ(frame_text(Pose::Identity()), "{xyz: [0, 0, 0], rpy: [0, 0, 0]}");
}

}  // namespace
}  // namespace wristwise
