// The keys for rails, positioners and parts on them: what is read, and what is refused.

#include <gtest/gtest.h>

#include "invalid_input.hpp"
#include "temporary_folder.hpp"
#include "wristwise/kinematics.hpp"
#include "wristwise/placement.hpp"
#include "wristwise/problem.hpp"

namespace wristwise {
namespace {

using test::invalid_input;
using test::replaced;
using test::says;
using test::TemporaryFolder;

constexpr double kDegree = 0.017453292519943295;

// A torch on a slide beside a table that turns.
constexpr const char* kUrdf = R"(<?xml version="1.0"?>
<robot name="cell">
  <link name="hall"/>
  <link name="carriage"><collision><geometry><sphere radius="0.1"/></geometry></collision></link>
  <link name="tip"/>
  <link name="table"><collision><geometry><sphere radius="0.1"/></geometry></collision></link>
  <joint name="rail" type="prismatic"><parent link="hall"/><child link="carriage"/>
    <axis xyz="1 0 0"/><limit lower="-2" upper="2" velocity="1" effort="1"/></joint>
  <joint name="roll" type="continuous"><parent link="carriage"/><child link="tip"/>
    <axis xyz="0 0 1"/><limit velocity="1" effort="1"/></joint>
  <joint name="turn" type="revolute"><origin xyz="1 0 0"/><parent link="hall"/>
    <child link="table"/><axis xyz="0 0 1"/>
    <limit lower="-3" upper="3" velocity="1" effort="1"/></joint>
</robot>
)";

constexpr const char* kProblem = R"(robot:
  urdf: cell.urdf
  tip_link: tip
  joint_ranges: {rail: [-1, 50 cm], turn: [0, 30 deg], roll: [-1, 1]}
scene:
  objects:
    - {name: pipe, link: table, sphere: 0.05}
    - {name: post, sphere: 0.05, xyz: [9, 0, 0]}
path:
  link: table
  speed: 0.1
  waypoints: 2
  segments:
    - line: {from: {xyz: [0, 0, 0]}, to: {xyz: [1, 0, 0]}}
cost: {joint_weights: {rail: 5}}
graph: {samples: {rail: 10 cm, turn: 10 deg, rz: 5 deg}}
)";

class ExternalAxesKeys : public testing::Test {
 protected:
  ExternalAxesKeys() { folder_.write("cell.urdf", kUrdf); }

  Problem load(const std::string& text) { return load_problem(folder_.write("p.yaml", text)); }

  std::string error(const std::string& old_part, const std::string& new_part) {
    const std::string message =
        invalid_input([&] { load(replaced(kProblem, old_part, new_part)); });
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    return message;
  }

  TemporaryFolder folder_;
};

TEST_F(ExternalAxesKeys, AreRead) {
  const Problem problem = load(kProblem);
  ASSERT_EQ(problem.robot->joint_count(), 3);
  const auto& joints = problem.robot->joints();
  EXPECT_EQ(joints[0].name, "turn");
  EXPECT_EQ(problem.robot->part_link(), "table");
  EXPECT_EQ(problem.robot->base_link(), "hall");
  EXPECT_EQ(joints[0].lower, 0);
  EXPECT_EQ(joints[0].upper, 30 * kDegree);
  EXPECT_EQ(joints[1].lower, -1);
  EXPECT_EQ(joints[1].upper, 0.5);
  EXPECT_EQ(joints[2].type, JointType::revolute);
  EXPECT_EQ(joints[2].upper, 1);
  EXPECT_EQ(problem.scene.objects[0].link, "table");
  EXPECT_EQ(problem.scene.objects[1].link, "");
  EXPECT_EQ(problem.cost.joint_weights, (std::vector<double>{1, 5, 1}));
  EXPECT_EQ(problem.graph.redundancy.size(), 2U);
  EXPECT_EQ(problem.graph.redundancy.at("rail"), 0.1);
  EXPECT_EQ(problem.graph.redundancy.at("turn"), 10 * kDegree);
  EXPECT_EQ(problem.graph.step[5], 5 * kDegree);
}

TEST_F(ExternalAxesKeys, AJointWithOneValueIsHeldThere) {
  const Problem free = load(kProblem);
  const Problem held = load(replaced(
      replaced(kProblem, "turn: [0, 30 deg], roll: [-1, 1]", "turn: 20 deg, roll: [0.4, 0.4]"),
      "turn: 10 deg, ", ""));
  ASSERT_EQ(held.robot->joint_count(), 1);
  EXPECT_EQ(held.robot->joints()[0].name, "rail");
  EXPECT_EQ(held.robot->part_link(), "table");
  JointVector all(3), one(1);
  for (const double rail : {-0.7, 0.0, 0.4}) {
    all << 20 * kDegree, rail, 0.4;
    one << rail;
    ChainPose of_all, of_one;
    forward_kinematics(*free.robot, all, of_all);
    forward_kinematics(*held.robot, one, of_one);
    EXPECT_LT((of_all.tcp.matrix() - of_one.tcp.matrix()).norm(), 1e-15);
    for (const Link& link : held.robot->links()) {
      const Link* same = free.robot->find_link(link.name);
      EXPECT_LT(((of_one.frame(link.joint) * link.pose).matrix() -
                 (of_all.frame(same->joint) * same->pose).matrix())
                    .norm(),
                1e-15)
          << link.name;
    }
  }
  EXPECT_TRUE(says(
      error("{rail: [-1, 50 cm], turn: [0, 30 deg], roll: [-1, 1]}", "{rail: 0, turn: 0, roll: 0}"),
      "every joint is held"));
}

TEST_F(ExternalAxesKeys, APartThatIsMovedIsNotPlaced) {
  const auto refusal = [&](const std::string& text) {
    return invalid_input([&] {
      place(load_placement(
          folder_.write("p.yaml", text + "placement: {move: part, with: all, x: 0.1}\n")));
    });
  };
  EXPECT_TRUE(says(refusal(kProblem), "the part is on 'table'"));
  const std::string standing =
      replaced(replaced(replaced(kProblem, "  link: table\n", ""), "turn: [0, 30 deg], ", ""),
               "turn: 10 deg, ", "");
  EXPECT_TRUE(says(refusal(standing), "object 'pipe' is fixed to 'table'"));
}

TEST_F(ExternalAxesKeys, WithoutThemNothingMovesThePart) {
  const std::string plain =
      replaced(replaced(replaced(kProblem, "  link: table\n", ""), "turn: [0, 30 deg], ", ""),
               "turn: 10 deg, ", "");
  const Problem problem = load(plain);
  EXPECT_EQ(problem.robot->joint_count(), 2);
  EXPECT_EQ(problem.robot->part_link(), "hall");
}

TEST_F(ExternalAxesKeys, BadValuesAreRefusedWithTheirPlace) {
  const struct {
    const char *old_part, *new_part, *place, *problem;
  } cases[] = {
      {"  link: table", "  link: tabel", "cell.urdf", "no link 'tabel'"},
      {"  link: table", "  link: tip", "cell.urdf", "moves the part's link 'tip'"},
      {"  link: table", "  link: carriage", "cell.urdf", "joint 'rail' moves"},
      {"  link: table", "  link: []", ":10: path.link", "a text"},
      {"link: table, sphere", "link: tabel, sphere", ":7: scene.objects[0].link", "'table'"},
      {"turn: [0, 30 deg], roll", "trun: 30 deg, roll", "robot.joint_ranges", "'turn'"},
      {"turn: [0, 30 deg], roll", "turn: 30 mm, roll", "robot.joint_ranges.turn", "an angle"},
      {"turn: [0, 30 deg], roll", "turn: 200 deg, roll", "robot.joint_ranges.turn",
       "limits -3 to 3"},
      {"[-1, 50 cm]", "[1, 50 cm]", "robot.joint_ranges.rail", "above the upper"},
      {"[-1, 50 cm]", "[1, .nan]", "robot.joint_ranges.rail", "not finite"},
      {"[-1, 50 cm]", "[1, 2, 3]", "robot.joint_ranges.rail", "[lower, upper]"},
      {"rail: 10 cm", "rail: 0", "graph.samples.rail", "not above zero"},
      {"rail: 10 cm", "rail: .nan", "graph.samples.rail", "not finite"},
      {"rail: 10 cm", "rail: 10 deg", "graph.samples.rail", "a length"},
      {"rail: 10 cm", "rial: 10 cm", "graph.samples.rial", "rail"},
      {"{rail: 5}", "{rial: 5}", "cost.joint_weights.rial", "rail"},
      {"{rail: 5}", "{rail: 0}", "cost.joint_weights.rail", "not above zero"},
      {"{rail: 5}", "[1, 2]", "cost.joint_weights", "{joint: weight}"},
  };
  for (const auto& c : cases) {
    const std::string message = error(c.old_part, c.new_part);
    EXPECT_TRUE(says(message, c.place)) << c.new_part << ": " << message;
    EXPECT_TRUE(says(message, c.problem)) << c.new_part << ": " << message;
  }
}

}  // namespace
}  // namespace wristwise
