#include <gtest/gtest.h>

#include <cmath>

#include "gantry_urdf.hpp"
#include "invalid_input.hpp"
#include "io/quantity.hpp"
#include "temporary_folder.hpp"
#include "wristwise/kinematics.hpp"
#include "wristwise/problem.hpp"

namespace wristwise {
namespace {

using test::invalid_input;
using test::replaced;
using test::says;
using test::TemporaryFolder;

constexpr double kDegree = 3.14159265358979323846 / 180;

constexpr const char* kProblem = R"(robot:
  urdf: gantry.urdf
  base_link: base
  tip_link: tip
  tool: {xyz: [0, 0, 5 cm], rpy: [0, 0, 90 deg]}
scene:
  collision: {pairs: [[carriage, plate]]}
  objects:
    - {name: plate, box: [0.2, 1.0, 20 mm], xyz: [0.9, 0, 0.01], rpy: [0, 0, 90 deg]}
    - {name: pole, cylinder: [0.1, 2]}
    - {name: ball, sphere: 0.3}
  clearance: 5 mm
path:
  frame: {xyz: [0, 1, 0], rpy: [0, 0, 90 deg]}
  speed: 60 cm/min
  spacing: 0.1
  segments:
    - line: {from: {xyz: [0, 0, 0]}, to: {xyz: [1, 0, 0], rpy: [0, 0, 10 deg]}}
    - arc: {from: {xyz: [1, 0, 0]}, center: [1, 1, 0], axis: [0, 0, 1], angle: 180 deg}
      tolerance: {x: 1 mm}
  tolerance:
    frame: base
    stick_out: [-2 mm, 0.003]
    travel_angle: 5 deg
    ry: [-0.1, 0.2]
    spin: free
    between: [0.2 mm, 0.2 deg]
cost: {joint_motion: 2, acceleration: 3, jerk: 4, euler: {graph: 5, refine: 6, eta: 7}, position: {graph: 8, refine: 9}, joint_weights: [1, 2, 3]}
graph: {samples: {rx: 5 deg, work_angle: 0.1, rz: 10 deg, z: 1 mm}, turns: principal, planner: dense}
refine: {smoothing_time: 1.5, knot_spacing: 200 ms, max_rounds: 7, max_iterations: 8, constraint_tolerance: 1e-8, clearance_epsilon: 0.1 mm, try_speeds: false}
controller: {period: 8 ms}
)";

class ProblemFile : public testing::Test {
 protected:
  ProblemFile() { folder_.write("gantry.urdf", test::kGantryUrdf); }

  Problem load(const std::string& text) {
    return load_problem(folder_.write("test_problem.yaml", text));
  }

  /// Loads the shipped text with one part replaced.
  std::string error(const std::string& old_part, const std::string& new_part) {
    const std::string text = replaced(kProblem, old_part, new_part);
    const std::string message = invalid_input([&] { load(text); });
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    return message;
  }

  TemporaryFolder folder_;
};

TEST_F(ProblemFile, EveryKeyIsRead) {
  const Problem problem = load(kProblem);
  EXPECT_EQ(problem.name, "test_problem");
  EXPECT_EQ(problem.robot->joint_count(), 3);
  EXPECT_LT(
      (tcp_pose(*problem.robot, JointVector::Zero(3)).translation() - Eigen::Vector3d(0, 0, 0.05))
          .norm(),
      1e-15);

  EXPECT_EQ(problem.scene.scope, CollisionScope::pairs);
  EXPECT_EQ(problem.scene.pairs, (std::vector<Scene::Names>{{"carriage", "plate"}}));
  EXPECT_EQ(problem.scene.clearance, 0.005);
  EXPECT_TRUE(problem.scene.find_permanent_contacts);
  ASSERT_EQ(problem.scene.objects.size(), 3u);
  const Shape& plate = problem.scene.objects[0].shapes[0];
  EXPECT_EQ(std::get<Box>(plate.geometry).size, Eigen::Vector3d(0.2, 1.0, 0.02));
  EXPECT_LT((plate.pose * Eigen::Vector3d(1, 0, 0) - Eigen::Vector3d(0.9, 1, 0.01)).norm(), 1e-15);
  EXPECT_EQ(std::get<Cylinder>(problem.scene.objects[1].shapes[0].geometry).length, 2);
  EXPECT_EQ(std::get<Sphere>(problem.scene.objects[2].shapes[0].geometry).radius, 0.3);

  const Task& task = problem.task;
  ASSERT_EQ(task.waypoints.size(), 11u + 32u);
  EXPECT_EQ(task.waypoints[10].time, 100);
  EXPECT_LT((task.waypoints[10].frame.translation() - Eigen::Vector3d(0, 2, 0)).norm(), 1e-15);
  EXPECT_LT((task.waypoints.back().frame.translation() - Eigen::Vector3d(-2, 2, 0)).norm(), 1e-14);
  const ToleranceBox& box = task.waypoints[0].tolerance;
  EXPECT_EQ(box.frame, ToleranceFrame::base);
  Vector6 lower, upper;
  lower << 0, 0, -0.002, -5 * kDegree, -0.1, -ToleranceBox::kFree;
  upper << 0, 0, 0.003, 5 * kDegree, 0.2, ToleranceBox::kFree;
  EXPECT_EQ(box.lower, lower);
  EXPECT_EQ(box.upper, upper);
  EXPECT_EQ(task.waypoints[11].tolerance.frame, ToleranceFrame::path);
  EXPECT_EQ(task.waypoints[11].tolerance.upper[0], 0.001);
  EXPECT_EQ(task.waypoints[11].tolerance.upper[5], 0);
  EXPECT_EQ(task.between_position, 0.0002);
  EXPECT_EQ(task.between_angle, 0.2 * kDegree);

  EXPECT_EQ(problem.cost.joint_motion, 2);
  EXPECT_EQ(problem.cost.acceleration, 3);
  EXPECT_EQ(problem.cost.jerk, 4);
  EXPECT_EQ(problem.cost.euler_graph, 5);
  EXPECT_EQ(problem.cost.euler_refine, 6);
  EXPECT_EQ(problem.cost.euler_eta, 7);
  EXPECT_EQ(problem.cost.position_graph, 8);
  EXPECT_EQ(problem.cost.position_refine, 9);
  EXPECT_EQ(problem.cost.joint_weights, (std::vector<double>{1, 2, 3}));
  Vector6 step;
  step << 0, 0, 0.001, 5 * kDegree, 0.1, 10 * kDegree;
  EXPECT_EQ(problem.graph.step, step);
  EXPECT_EQ(problem.graph.turns, Turns::principal);
  EXPECT_EQ(problem.refine.smoothing_time, 1.5);
  EXPECT_EQ(problem.refine.knot_spacing, 0.2);
  EXPECT_EQ(problem.refine.max_rounds, 7);
  EXPECT_EQ(problem.refine.max_iterations, 8);
  EXPECT_EQ(problem.refine.constraint_tolerance, 1e-8);
  EXPECT_EQ(problem.refine.clearance_epsilon, 0.0001);
  EXPECT_FALSE(problem.refine.try_speeds);
  EXPECT_EQ(problem.controller_period, 0.008);
}

TEST_F(ProblemFile, DefaultsAreThoseOfTheHeaders) {
  const Problem problem = load(
      "robot: {urdf: gantry.urdf}\n"
      "path: {speed: 1, waypoints: 3, segments: [line: {from: {xyz: [0, 0, 0]}, "
      "to: {xyz: [1, 0, 0]}}]}\n");
  EXPECT_EQ(problem.scene.scope, CollisionScope::all);
  EXPECT_EQ(problem.scene.clearance, 0);
  EXPECT_EQ(problem.task.waypoints[1].tolerance.lower, Vector6::Zero());
  EXPECT_EQ(problem.task.waypoints[1].tolerance.upper, Vector6::Zero());
  EXPECT_EQ(problem.task.between_position, Task().between_position);
  EXPECT_EQ(problem.task.between_angle, Task().between_angle);
  EXPECT_EQ(problem.graph.turns, Turns::all);
  EXPECT_EQ(problem.refine.smoothing_time, RefineOptions().smoothing_time);
}

TEST_F(ProblemFile, MistakesAreNamedWithFileLineAndKey) {
  struct Case {
    std::string old_part, new_part, where, what;
  };
  const std::vector<Case> cases = {
      {"  spacing: 0.1", "  spacng: 0.1", ":16: path.spacng", "'spacing'"},
      {"clearance: 5 mm", "clearence: 5 mm", ":12: scene.clearence", "'clearance'"},
      {"turns:", "turn:", ":29: graph.turn", "'turns'"},
      {"controller:", "controler:", ":31: controler", "'controller'"},
      {"stick_out:", "stickout:", ":23: path.tolerance.stickout", "'stick_out'"},
      {"tolerance: {x: 1 mm}", "tolerance: {between: [0, 0]}", "path.segments[1].tolerance.between",
       "unknown key"},
      {"spacing: 0.1", "spacing: 10 deg", ":16: path.spacing", "unit of an angle"},
      {"rpy: [0, 0, 10 deg]", "rpy: [0, 0, 10 mm]", ":18: path.segments[0].line.to.rpy[2]",
       "unit of a length"},
      {"spacing: 0.1", "spacing: 4 inch", "path.spacing", "unknown unit"},
      {"spacing: 0.1", "spacing: wide", "path.spacing", "'wide' is not a number"},
      {"spacing: 0.1", "spacing: 0", "path.spacing", "not above zero"},
      {"spacing: 0.1", "spacing: -1", "path.spacing", "not above zero"},
      {"spacing: 0.1", "spacing: .nan", "path.spacing", "not finite"},
      {"spacing: 0.1", "spacing: 1e-9", "path", "at most a million"},
      {"spacing: 0.1", "spacing: 0.1\n  waypoints: 5", "path", "both"},
      {"spacing: 0.1", "waypoints: 1", ":16: path.waypoints", "at least 2"},
      {"spacing: 0.1", "waypoints: 5.5", "path.waypoints", "whole number"},
      {"  spacing: 0.1\n", "", "path", "neither"},
      {"speed: 60 cm/min", "speed: 0", ":15: path.speed", "not above zero"},
      {"speed: 60 cm/min", "speed: -0.01", "path.speed", "not above zero"},
      {"speed: 60 cm/min", "speed: .inf", "path.speed", "not finite"},
      {"  speed: 60 cm/min\n", "", "path", "speed"},
      {"{xyz: [0, 0, 0]}", "{xyz: [0, .nan, 0]}", ":18: path.segments[0].line.from.xyz[1]",
       "not finite"},
      {"{xyz: [0, 0, 0]}", "{xyz: [0, 0]}", ":18: path.segments[0].line.from.xyz", "a list of 2"},
      {"{xyz: [0, 0, 0]}", "{rpy: [0, 0, 0]}", ":18: path.segments[0].line.from", "'xyz'"},
      {"{xyz: [0, 0, 0]}", "{xyz: [1, 0, 0]}", ":18: path.segments[0].line.to.xyz", "repeated"},
      {"from: {xyz: [1, 0, 0]}", "from: {xyz: [1, 0.5, 0]}", ":19: path.segments[1].arc",
       "0.5 m from the end"},
      {"center: [1, 1, 0]", "center: [1, 0, 7]", "path.segments[1].arc", "radius is zero"},
      {"axis: [0, 0, 1]", "axis: [0, 0, 0]", "path.segments[1].arc.axis", "zero"},
      {"angle: 180 deg", "angle: 0", "path.segments[1].arc", "repeated waypoint"},
      {"ry: [-0.1, 0.2]", "ry: [0.3, 0.2]", ":25: path.tolerance.ry", "above the upper"},
      {"ry: [-0.1, 0.2]", "ry: -0.1", "path.tolerance.ry", "negative"},
      {"ry: [-0.1, 0.2]", "ry: 100 deg", ":21: path.tolerance", "90"},
      {"stick_out: [-2 mm, 0.003]", "z: free", "path.tolerance.z", "rotations"},
      {"stick_out: [-2 mm, 0.003]", "z: 0\n    stick_out: 0", "path.tolerance.stick_out",
       "same as z"},
      {"frame: base", "frame: world", "path.tolerance.frame", "path or base"},
      {"between: [0.2 mm, 0.2 deg]", "between: 0.2 mm", "path.tolerance.between", "angle"},
      {"clearance: 5 mm", "clearance: -5 mm", "scene.clearance", "negative"},
      {"[carriage, plate]", "[carriage, plat]", "scene.collision.pairs[0][1]", "'plate'"},
      {"collision: {pairs: [[carriage, plate]]}", "collision: of", "scene.collision", "off"},
      {"name: pole", "name: plate", ":10: scene.objects[1].name", "another"},
      {"sphere: 0.3", "sphere: -0.3", "scene.objects[2].sphere", "not above zero"},
      {"sphere: 0.3", "mesh: none.stl", ":11: scene.objects[2].mesh", "no such file"},
      {"sphere: 0.3", "colour: red", "scene.objects[2].colour", "unknown key"},
      {", sphere: 0.3", "", "scene.objects[2]", "no shape"},
      {"sphere: 0.3", "sphere: 0.3, scale: 2", "scene.objects[2].scale", "mesh"},
      {"urdf: gantry.urdf", "urdf: none.urdf", ":2: robot.urdf", "no such file"},
      {"urdf: gantry.urdf", "urdf: package://nowhere/a.urdf", ":2: robot.urdf",
       "package://nowhere"},
      {"tip_link: tip", "tip_link: tap", "gantry.urdf", "'tap'"},
      {"base_link: base", "base_link: tip", "gantry.urdf", ""},
      {"planner: dense", "planner: quick", ":29: graph.planner", "sparse"},
      {"planner: dense", "seeds: 0", ":29: graph.seeds", "at least 1"},
      {"planner: dense", "automatic_samples: 100", ":29: graph.automatic_samples",
       "samples are given too"},
      {"planner: dense", "max_tcp_step: -1", ":29: graph.max_tcp_step", "not above zero"},
      {"planner: dense", "collision_checks: never", ":29: graph.collision_checks", "eager"},
      {"planner: dense", "check_moves: never", ":29: graph.check_moves", "false"},
      {"joint_weights: [1, 2, 3]", "joint_weights: [1, 2]", ":28: cost.joint_weights", "3"},
      {"eta: 7", "eta: -7", "cost.euler.eta", "negative"},
      {"max_rounds: 7", "max_rounds: 0", "refine.max_rounds", "at least 1"},
      {"period: 8 ms", "period: 0", ":31: controller.period", "not above zero"},
      {"controller: {period: 8 ms}", "controller:", ":31: controller", "no value"},
      {"controller: {period: 8 ms}", "path: {}", ":31", "given twice"},
      {"spacing: 0.1", "spacing: 0.1\n  spacing: 0.2", ":17", "given twice"},
      {"spacing: 0.1", "spacing: [0.1", "test_problem.yaml:", "YAML"},
  };
  for (const Case& mistake : cases) {
    const std::string message = error(mistake.old_part, mistake.new_part);
    EXPECT_TRUE(says(message, mistake.where)) << message << "\nexpected " << mistake.where;
    EXPECT_TRUE(says(message, mistake.what)) << message << "\nexpected " << mistake.what;
  }
}

TEST_F(ProblemFile, EmptyAndForeignFiles) {
  EXPECT_TRUE(
      says(invalid_input([&] { load_problem(folder_.path() / "none.yaml"); }), "none.yaml"));
  EXPECT_TRUE(says(invalid_input([&] { load_problem(folder_.path()); }), "folder"));
  for (const char* text : {"", "# nothing\n", "[1, 2]\n", "hello\n", "a: 1\n---\nb: 2\n",
                           "a: &a [*a]\n", "\x01\x02", "robot: {}\n", "path: {}\n"})
    invalid_input([&] { load(text); });
  EXPECT_TRUE(says(invalid_input([&] {
                     load("robot: {urdf: gantry.urdf}\npath: {speed: 1, spacing: 1, segments: []}");
                   }),
                   "path.segments: no segments"));
}

class PathProblem : public ProblemFile {
 protected:
  Task task(const std::string& segments, const std::string& more = "speed: 0.1") {
    return load("robot: {urdf: gantry.urdf}\nscene: {collision: off}\npath:\n  " + more +
                "\n  frame: {xyz: [0, 0, 1], rpy: [0, 0, 90 deg]}\n  segments:\n" + segments)
        .task;
  }
};

TEST_F(PathProblem, PosesComeFromACsvFile) {
  folder_.write("seam.csv",
                "qw,qx,qy,qz,x,y,z,time\n1,0,0,0,0,0,0,0\n0.70711,0,0,0.70711,1,0,0,4\n");
  const Task with_times = task("    - poses: seam.csv\n", "spacing: 0.5");
  ASSERT_EQ(with_times.waypoints.size(), 3u);
  EXPECT_EQ(with_times.waypoints[2].time, 4);
  const Pose& end = with_times.waypoints[2].frame;
  EXPECT_LT((end.translation() - Eigen::Vector3d(0, 1, 1)).norm(), 1e-15);
  EXPECT_LT((end.linear() * Eigen::Vector3d::UnitX() + Eigen::Vector3d::UnitX()).norm(), 1e-5);
  EXPECT_LT((end.linear() * end.linear().transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-15);

  folder_.write("seam.csv", "x,y,z,qw,qx,qy,qz\n0,0,0,1,0,0,0\n1,0,0,1,0,0,0\n");
  EXPECT_NEAR(task("    - poses: seam.csv\n").waypoints.back().time, 10, 1e-12);
}

TEST_F(PathProblem, MistakesInACsvFileAreNamed) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"x,y,z,qw,qx,qy,qz\n0,0,0,1,0,0,0\n1,0,0,1,0.1,0,0\n", "seam.csv:3: the quaternion"},
      {"x,y,z,qw,qx,qy,qz\n0,0,0,1,0,0,0\n0,0,0,1,0,0,0\n", "seam.csv:3: repeated waypoint"},
      {"x,y,z,qw,qx,qy,qz\n0,0,0,1,0,0,0\n", "one waypoint"},
      {"x,y,z,qw,qx,qy,qz\n", "no poses"},
      {"x,y,z,qw,qx,qy\n0,0,0,1,0,0\n", "no column 'qz'"},
      {"x,y,z,qw,qx,qy,qz,time\n0,0,0,1,0,0,0,1\n1,0,0,1,0,0,0,1\n", "seam.csv:3: time"},
      {"x,y,z,qw,qx,qy,qz\n0,0,0,1,0,0,0\nnan,0,0,1,0,0,0\n", "seam.csv:3: 'nan'"},
  };
  for (const auto& [text, what] : cases) {
    folder_.write("seam.csv", text);
    const std::string message = invalid_input([&] { task("    - poses: seam.csv\n"); });
    EXPECT_TRUE(says(message, what)) << message;
  }
}

TEST_F(PathProblem, JointWaypointsAreInJointSpace) {
  const Task with_joints = task("    - joints: [[0, 0.5, 90 deg], [200 mm, 0.5, 0]]\n");
  ASSERT_EQ(with_joints.waypoints.size(), 2u);
  JointVector q(3);
  q << 0, 0.5, 90 * kDegree;
  EXPECT_EQ(with_joints.waypoints[0].joints->lower, q);
  EXPECT_EQ(with_joints.waypoints[0].joints->upper, q);
  EXPECT_LT((with_joints.waypoints[0].frame.translation() - Eigen::Vector3d(0, 0.5, 0)).norm(),
            1e-15);
  const std::string message =
      invalid_input([&] { task("    - joints: [[0, 0.5], [0.2, 0.5, 0]]\n"); });
  EXPECT_TRUE(says(message, ":7: path.segments[0].joints[0]")) << message;
}

TEST(Quantity, UnitsAreExact) {
  EXPECT_EQ(parse_quantity("10 mm", Quantity::length, ""), 0.01);
  EXPECT_EQ(parse_quantity("+0.5mm", Quantity::length, ""), 0.0005);
  EXPECT_EQ(parse_quantity("1e-3", Quantity::length, ""), 0.001);
  EXPECT_EQ(parse_quantity(" -2 cm ", Quantity::length, ""), -0.02);
  EXPECT_EQ(parse_quantity("180 deg", Quantity::angle, ""), 180 * kDegree);
  EXPECT_EQ(parse_quantity("1e2deg", Quantity::angle, ""), 100 * kDegree);
  EXPECT_EQ(parse_quantity("60 cm/min", Quantity::speed, ""), 0.01);
  for (const char* text : {"", "mm", "1 2", "--1", "1,5", "0x10", "1 deg", "nan", "-.inf", "1e400"})
    invalid_input([&] { parse_quantity(text, Quantity::length, "here"); });
}

}  // namespace
}  // namespace wristwise
