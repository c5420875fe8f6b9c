#include <gtest/gtest.h>

#include <array>

#include "gantry_urdf.hpp"
#include "invalid_input.hpp"
#include "temporary_folder.hpp"
#include "wristwise/problem.hpp"

namespace wristwise {
namespace {

using test::invalid_input;
using test::replaced;
using test::says;
using test::TemporaryFolder;

constexpr double kDegree = 3.14159265358979323846 / 180;

class WaypointKeys : public testing::Test {
 protected:
  WaypointKeys() { folder_.write("gantry.urdf", test::kGantryUrdf); }

  /// The segments begin on line 7.
  Problem load(const std::string& segments, const std::string& more = "speed: 0.1") {
    return load_problem(folder_.write("test_problem.yaml",
                                      "robot: {urdf: gantry.urdf}\nscene: {collision: off}\n"
                                      "path:\n  " +
                                          more +
                                          "\n  frame: {xyz: [0, 0, 1], rpy: [0, 0, 90 deg]}\n"
                                          "  segments:\n" +
                                          segments));
  }
  Task task(const std::string& segments, const std::string& more = "speed: 0.1") {
    return load(segments, more).task;
  }

  TemporaryFolder folder_;
};

TEST_F(WaypointKeys, JointWaypointsMayHaveRanges) {
  const Task with_ranges =
      task("    - joints: [[[-10 mm, 0.03], 0.5, [-90 deg, 0]], [0.5, [1.9, 3], 0]]\n");
  ASSERT_EQ(with_ranges.waypoints.size(), 2u);
  const JointBox& first = *with_ranges.waypoints[0].joints;
  const Eigen::Vector3d lower(-0.01, 0.5, -90 * kDegree), upper(0.03, 0.5, 0);
  EXPECT_EQ(first.lower, lower);
  EXPECT_EQ(first.upper, upper);
  EXPECT_LT((with_ranges.waypoints[0].frame.translation() - Eigen::Vector3d(0.01, 0.5, 0)).norm(),
            1e-15);
  EXPECT_EQ(with_ranges.waypoints[1].joints->lower[1], 1.9);
  EXPECT_EQ(with_ranges.waypoints[1].joints->upper[1], 2);  // the limit
}

TEST_F(WaypointKeys, MistakesInJointWaypointsAreNamed) {
  const std::string place = ":7: path.segments[0].joints[1]";
  const std::vector<std::array<std::string, 3>> cases = {
      {"[0.2, [0.6, 0.5], 0]", place + "[1]", "the lower bound is above the upper"},
      {"[0.2, [0.5], 0]", place + "[1]", "a value or [lower, upper]"},
      {"[0.2, [0.4, 0.5, 0.6], 0]", place + "[1]", "a value or [lower, upper]"},
      {"[0.2, [0.5, 90 deg], 0]", place + "[1][1]", "unit of an angle"},
      {"[0.2, 0.5, [0, 10 mm]]", place + "[2][1]", "unit of a length"},
      {"[0.2, [.nan, 0.5], 0]", place + "[1][0]", "not finite"},
      {"[0.2, [0, .inf], 0]", place + "[1][1]", "not finite"},
      {"[0.2, free, 0]", place + "[1]", "'free' is not a number"},
      {"[0.2, [2.5, 3], 0]", place, "y = [2.5, 3] is outside its limits; expected -2 to 2"},
      {"[0.2, 2.5, 0]", place, "y = 2.5 is outside its limits; expected -2 to 2"},
      {"[[-1, 1], [-1, 1], 0]", place, "repeated waypoint"},
  };
  for (const auto& [posture, where, what] : cases) {
    const std::string message =
        invalid_input([&] { task("    - joints: [[0, 0, 0], " + posture + "]\n"); });
    EXPECT_TRUE(says(message, where)) << message << "\nexpected " << where;
    EXPECT_TRUE(says(message, what)) << message << "\nexpected " << what;
  }
  const std::string message = invalid_input(
      [&] { task("    - joints: [[0, 0, 0], [1, 0, 0]]\n      tolerance: {rx: 5 deg}\n"); });
  EXPECT_TRUE(says(message, ":8: path.segments[0].tolerance: joint waypoints have no")) << message;
}

constexpr const char* kLine =
    "    - line: {from: {xyz: [0, 0, 0]}, to: {xyz: [1, 0, 0]}}\n      tolerance: ";

TEST_F(WaypointKeys, AnAxiallySymmetricToolIsFreeAboutThatAxis) {
  for (int axis = 0; axis < 3; ++axis) {
    const std::string name(1, static_cast<char>('x' + axis));
    for (const std::string& redundant : {std::string(), ", r" + name + ": free"}) {
      const Task symmetric =
          task(kLine + ("{z: 1 mm, axially_symmetric: " + name) + redundant + "}\n",
               "speed: 1\n  spacing: 1");
      Vector6 upper = Vector6::Zero();
      upper[2] = 0.001;
      upper[3 + axis] = ToleranceBox::kFree;
      EXPECT_EQ(symmetric.waypoints[1].tolerance.upper, upper);
      EXPECT_EQ(symmetric.waypoints[1].tolerance.lower, -upper);
    }
  }
  const std::vector<std::array<std::string, 3>> cases = {
      {"{axially_symmetric: x, rx: 5 deg}", "tolerance.rx", "contradicts axially_symmetric: x"},
      {"{axially_symmetric: y, ry: [-0.1, 0]}", "tolerance.ry", "contradicts axially_symmetric: y"},
      {"{axially_symmetric: z, rz: 0}", "tolerance.rz", "contradicts axially_symmetric: z"},
      {"{axially_symmetric: z, spin: 1}", "tolerance.spin", "contradicts axially_symmetric: z"},
      {"{axially_symmetric: rz}", "tolerance.axially_symmetric", "x or y or z"},
      {"{axially_symmetric: [x, y]}", "tolerance.axially_symmetric", "x or y or z"},
      {"{axially_symmetric: x, rz: 95 deg}", "tolerance.rz", "90 deg"},
  };
  for (const auto& [tolerance, where, what] : cases) {
    const std::string message =
        invalid_input([&] { task(kLine + tolerance + "\n", "speed: 1\n  spacing: 1"); });
    EXPECT_TRUE(says(message, ":9: path.segments[0]." + where)) << message;
    EXPECT_TRUE(says(message, what)) << message;
  }
}

TEST_F(WaypointKeys, RangesOfJointsHaveStepsOfTheirOwn) {
  const auto steps = [&](const std::string& urdf, const std::string& joints) {
    folder_.write("gantry.urdf", urdf);
    return load("    - joints: [[0, 0, 0], [1, 0, 0]]\ngraph: {samples: {joints: " + joints +
                "}}\n")
        .graph.joint_step;
  };
  const std::string turning = test::kGantryUrdf;
  const std::string sliding = replaced(turning, "\"revolute\"", "\"prismatic\"");
  EXPECT_EQ(steps(sliding, "5 mm"), (std::vector<double>{0.005, 0.005, 0.005}));
  EXPECT_EQ(steps(turning, "[5 mm, 0, 5 deg]"), (std::vector<double>{0.005, 0, 5 * kDegree}));
  const std::vector<std::array<std::string, 3>> cases = {
      {"5 mm", "graph.samples.joints", "unit of a length"},
      {"[5 mm, 1]", "graph.samples.joints", "list of 3, one per joint"},
      {"[5 mm, 5 deg, 1]", "graph.samples.joints[1]", "unit of an angle"},
      {"[5 mm, -1, 1]", "graph.samples.joints[1]", "negative"},
  };
  for (const auto& [joints, where, what] : cases) {
    const std::string message = invalid_input([&] { steps(turning, joints); });
    EXPECT_TRUE(says(message, ":8: " + where)) << message;
    EXPECT_TRUE(says(message, what)) << message;
  }
}

}  // namespace
}  // namespace wristwise
