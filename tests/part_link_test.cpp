// Robots whose chain starts at a link that the positioner moves. The oracle multiplies the joints
// of the URDF's tree from the root down, as they are written in it, and knows no chain.

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <map>
#include <random>
#include <string>
#include <vector>

#include "invalid_input.hpp"
#include "temporary_folder.hpp"
#include "wristwise/clearance.hpp"
#include "wristwise/kinematics.hpp"
#include "wristwise/urdf.hpp"

namespace wristwise {
namespace {

using test::invalid_input;
using test::says;
using test::TemporaryFolder;

/// A joint of a tree as a URDF has it; link i + 1 hangs on joint i.
struct TreeJoint {
  std::string name, type;
  int parent = 0;  // link
  Eigen::Vector3d xyz, rpy, axis;
};

std::string link_name(int link) { return fmt::format("l{}", link); }

std::string text(const Eigen::Vector3d& v) {
  return fmt::format("{:.17g} {:.17g} {:.17g}", v.x(), v.y(), v.z());
}

Eigen::Matrix3d turn(const Eigen::Vector3d& axis, double angle) {
  return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

struct Tree {
  std::vector<TreeJoint> joints;

  std::string urdf() const {
    std::string result = "<robot name=\"tree\">\n";
    for (int i = 0; i <= static_cast<int>(joints.size()); ++i) {
      result += fmt::format(
          "<link name=\"{}\"><collision><geometry><sphere radius=\"0.01\"/></geometry></collision>"
          "</link>\n",
          link_name(i));
    }
    for (std::size_t i = 0; i < joints.size(); ++i) {
      const TreeJoint& j = joints[i];
      result += fmt::format(
          "<joint name=\"{}\" type=\"{}\"><origin xyz=\"{}\" rpy=\"{}\"/><parent link=\"{}\"/>"
          "<child link=\"{}\"/><axis xyz=\"{}\"/>"
          "<limit lower=\"-1.5\" upper=\"2\" effort=\"0\" velocity=\"3\"/></joint>\n",
          j.name, j.type, text(j.xyz), text(j.rpy), link_name(j.parent),
          link_name(static_cast<int>(i) + 1), text(j.axis));
    }
    return result + "</robot>\n";
  }

  /// In the root, with the joints' values by name (0 where there is none).
  Pose link_pose(int link, const std::map<std::string, double>& values) const {
    if (link == 0) return Pose::Identity();
    const TreeJoint& joint = joints[static_cast<std::size_t>(link - 1)];
    Pose step = Pose::Identity();
    step.linear() = turn({0, 0, 1}, joint.rpy.z()) * turn({0, 1, 0}, joint.rpy.y()) *
                    turn({1, 0, 0}, joint.rpy.x());
    step.translation() = joint.xyz;
    const auto found = values.find(joint.name);
    const double value = found == values.end() ? 0 : found->second;
    if (joint.type == "prismatic") step.translate(value * joint.axis.normalized());
    if (joint.type == "revolute") step.rotate(turn(joint.axis, value));
    return link_pose(joint.parent, values) * step;
  }

  bool is_above(int ancestor, int link) const {
    for (; link != 0; link = joints[static_cast<std::size_t>(link - 1)].parent)
      if (link == ancestor) return true;
    return ancestor == 0;
  }
};

class Random {
 public:
  explicit Random(unsigned seed) : rng_(seed) {}
  double uniform(double lower, double upper) {
    return std::uniform_real_distribution<double>(lower, upper)(rng_);
  }
  Eigen::Vector3d vector(double size) {
    return {uniform(-size, size), uniform(-size, size), uniform(-size, size)};
  }
  int below(int count) { return std::uniform_int_distribution<int>(0, count - 1)(rng_); }

  Tree tree(int count) {
    const char* const types[] = {"revolute", "revolute", "prismatic", "fixed"};
    Tree result;
    for (int i = 0; i < count; ++i) {
      const int parent = std::max(0, i - below(3));  // long branches
      result.joints.push_back(
          {fmt::format("j{}", i), types[below(4)], parent, vector(0.5), vector(3), vector(1)});
    }
    return result;
  }

 private:
  std::mt19937 rng_;
};

double difference(const Pose& a, const Pose& b) {
  return (a.matrix() - b.matrix()).cwiseAbs().maxCoeff();
}

std::map<std::string, double> named(const Robot& robot, const JointVector& q) {
  std::map<std::string, double> values;
  for (int j = 0; j < robot.joint_count(); ++j)
    values[robot.joints()[static_cast<std::size_t>(j)].name] = q[j];
  return values;
}

JointVector posture(const Robot& robot, Random& random) {
  JointVector q(robot.joint_count());
  for (double& value : q) value = random.uniform(-1.5, 2);
  return q;
}

/// Joints that move exactly one of the two links are on the chain, or else it throws.
bool has_shared_joint(const Tree& tree, int part, int tip) {
  for (int link = 1; link <= static_cast<int>(tree.joints.size()); ++link) {
    if (tree.joints[static_cast<std::size_t>(link - 1)].type == "fixed") continue;
    if (tree.is_above(link, part) && tree.is_above(link, tip)) return true;
  }
  return false;
}

int moving_joints(const Tree& tree, int part, int tip) {
  int count = 0;
  for (int link = 1; link <= static_cast<int>(tree.joints.size()); ++link) {
    if (tree.joints[static_cast<std::size_t>(link - 1)].type == "fixed") continue;
    if (tree.is_above(link, part) != tree.is_above(link, tip)) ++count;
  }
  return count;
}

TEST(PartLink, PosesAndJacobiansAreThoseOfTheTreeSeenFromThePart) {
  Random random(11);
  const TemporaryFolder folder;
  const int links = 9;
  int compared = 0, with_reversed = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const Tree tree = random.tree(links - 1);
    const int part = random.below(links), tip = random.below(links);
    const int movable = moving_joints(tree, part, tip);
    if (movable == 0 || has_shared_joint(tree, part, tip)) continue;
    RobotSource source;
    source.urdf = folder.write("tree.urdf", tree.urdf());
    source.part_link = link_name(part);
    source.tip_link = link_name(tip);
    const Robot robot = load_robot(source);
    ASSERT_EQ(robot.joint_count(), movable);
    EXPECT_EQ(robot.part_link(), link_name(part));
    EXPECT_EQ(robot.base_link(), "l0");
    with_reversed += part != 0 ? 1 : 0;
    for (int k = 0; k < 3; ++k, ++compared) {
      const JointVector q = posture(robot, random);
      const auto values = named(robot, q);
      const Pose from_part = tree.link_pose(part, values).inverse();
      ChainPose chain;
      forward_kinematics(robot, q, chain);
      EXPECT_LT(difference(chain.tcp, from_part * tree.link_pose(tip, values)), 1e-12);
      ASSERT_EQ(robot.links().size(), static_cast<std::size_t>(links));
      for (int link = 0; link < links; ++link) {
        const Link* placed = robot.find_link(link_name(link));
        ASSERT_NE(placed, nullptr);
        EXPECT_LT(difference(chain.frame(placed->joint) * placed->pose,
                             from_part * tree.link_pose(link, values)),
                  1e-12);
      }
      const Jacobian jacobian = geometric_jacobian(robot, chain);
      const double h = 1e-6;
      for (int j = 0; j < robot.joint_count(); ++j) {
        JointVector forward = q, back = q;
        forward[j] += h;
        back[j] -= h;
        const auto tcp = [&](const JointVector& at) {
          const auto moved = named(robot, at);
          return Pose(tree.link_pose(part, moved).inverse() * tree.link_pose(tip, moved));
        };
        const Pose ahead = tcp(forward), behind = tcp(back);
        const Eigen::Vector3d linear = (ahead.translation() - behind.translation()) / (2 * h);
        const Eigen::Matrix3d spin =
            (ahead.linear() - behind.linear()) * chain.tcp.linear().transpose() / (2 * h);
        EXPECT_LT((jacobian.col(j).head<3>() - linear).norm(), 1e-8);
        EXPECT_LT((jacobian.col(j).tail<3>() - Eigen::Vector3d(spin(2, 1), spin(0, 2), spin(1, 0)))
                      .norm(),
                  1e-8);
      }
    }
  }
  EXPECT_GT(compared, 150);
  EXPECT_GT(with_reversed, 30);
}

// world - (mount) - arm_base - (a) - arm - (b) - torch; world - (tilt) - frame - (turn) - table
Tree cell() {
  const Eigen::Vector3d x(1, 0, 0), y(0, 1, 0), z(0, 0, 1), none(0, 0, 0);
  Tree tree;
  tree.joints = {{"mount", "fixed", 0, none, none, z},           // l1: arm's base
                 {"a", "revolute", 1, {0, 0, 0.4}, none, z},     // l2
                 {"b", "revolute", 2, {0.5, 0, 0}, none, y},     // l3: tip
                 {"tilt", "revolute", 0, {1, 0, 0.3}, none, x},  // l4
                 {"turn", "revolute", 4, {0, 0, 0.1}, none, z},  // l5: table
                 {"clamp", "fixed", 5, {0, 0, 0.05}, none, z}};  // l6
  return tree;
}

Robot load_cell(const TemporaryFolder& folder, const std::string& part,
                const std::string& base = {}) {
  RobotSource source;
  source.urdf = folder.write("cell.urdf", cell().urdf());
  source.base_link = base;
  source.tip_link = "l3";
  source.part_link = part;
  return load_robot(source);
}

TEST(PartLink, ThePositionersJointsComeFirstWithTheirOwnNamesAndLimits) {
  const TemporaryFolder folder;
  const Robot robot = load_cell(folder, "l6");
  std::vector<std::string> names;
  for (const Joint& joint : robot.joints()) names.push_back(joint.name);
  EXPECT_EQ(names, (std::vector<std::string>{"turn", "tilt", "a", "b"}));
  for (const Joint& joint : robot.joints()) {
    EXPECT_EQ(joint.lower, -1.5);
    EXPECT_EQ(joint.upper, 2);
  }
  EXPECT_EQ(robot.find_link("l5")->joint, -1);
  EXPECT_EQ(robot.find_link("l4")->joint, 0);
  EXPECT_EQ(robot.find_link("l0")->joint, 1);
  EXPECT_EQ(robot.find_link("l1")->joint, 1);
  EXPECT_TRUE(robot.warnings().empty()) << robot.warnings().front();
}

TEST(PartLink, WithoutItThePositionerIsHeld) {
  const TemporaryFolder folder;
  const Robot robot = load_cell(folder, "");
  EXPECT_EQ(robot.joint_count(), 2);
  EXPECT_EQ(robot.part_link(), "l0");
  EXPECT_EQ(robot.warnings().size(), 2U);
}

TEST(PartLink, JointsAboveTheBaseAreHeldOnTheWayToThePartToo) {
  const TemporaryFolder folder;
  RobotSource source;
  Tree tree = cell();
  tree.joints[0].type = "prismatic";  // the arm on a rail, which the base link leaves out
  source.urdf = folder.write("cell.urdf", tree.urdf());
  source.base_link = "l1";
  source.tip_link = "l3";
  source.part_link = "l5";
  const Robot robot = load_robot(source);
  ASSERT_EQ(robot.joint_count(), 4);
  ASSERT_EQ(robot.warnings().size(), 1U);
  EXPECT_TRUE(says(robot.warnings()[0], "mount")) << robot.warnings()[0];
  source.base_link = "";
  EXPECT_EQ(load_robot(source).joint_count(), 5);
}

TEST(PartLink, RefusesLinksThatAreNoPart) {
  const TemporaryFolder folder;
  const auto refusal = [&](const std::string& part) {
    return invalid_input([&] { load_cell(folder, part); });
  };
  EXPECT_TRUE(says(refusal("l9"), "no link 'l9'")) << refusal("l9");
  EXPECT_TRUE(says(refusal("l3"), "joint 'b' moves")) << refusal("l3");  // the tip itself
  EXPECT_TRUE(says(refusal("l2"), "joint 'a' moves")) << refusal("l2");  // on the arm
  EXPECT_EQ(load_cell(folder, "l1").joint_count(), 2);  // does not move: as good as the base
}

Scene all_objects(std::vector<SceneObject> objects) {
  Scene scene;
  scene.objects = std::move(objects);
  return scene;
}

std::vector<std::string> pair_names(const ClearanceModel& model) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < model.pairs().size(); ++i) {
    const auto [a, b] = model.names(static_cast<int>(i));
    names.push_back(a + "-" + b);
  }
  return names;
}

bool has(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

TEST(PartLink, ObjectsStandInTheBaseOrMoveWithTheirLink) {
  const TemporaryFolder folder;
  const Tree tree = cell();
  const auto robot = std::make_shared<const Robot>(load_cell(folder, "l6"));
  const Pose placed(Eigen::Translation3d(0.1, 0.2, 0.3) *
                    Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitX()));
  const ClearanceModel model(robot, all_objects({{"post", {{Sphere{0.02}, placed}}},
                                                 {"pipe", {{Sphere{0.02}, placed}}, "l5"},
                                                 {"box", {{Sphere{0.02}, placed}}, "l3"}}));
  Random random(3);
  const std::map<std::string, int> carriers = {{"post", 0}, {"pipe", 5}, {"box", 3}};
  int found = 0;
  for (int k = 0; k < 20; ++k) {
    const JointVector q = posture(*robot, random);
    const auto values = named(*robot, q);
    ChainPose chain;
    forward_kinematics(*robot, q, chain);
    for (const ClearanceModel::Body& body : model.bodies()) {
      const auto carrier = carriers.find(body.name);
      if (carrier == carriers.end()) continue;
      ++found;
      const Pose expected =
          tree.link_pose(6, values).inverse() * tree.link_pose(carrier->second, values) * placed;
      EXPECT_LT(difference(chain.frame(body.joint) * body.shapes[0].pose, expected), 1e-12);
    }
  }
  EXPECT_EQ(found, 60);
  // Whatever moves against each other counts, objects against objects too; what does not, not.
  const auto names = pair_names(model);
  for (const char* pair : {"post-pipe", "post-box", "pipe-box", "l3-pipe", "l3-post", "l0-pipe"})
    EXPECT_TRUE(has(names, pair)) << pair;
  for (const char* pair : {"l5-pipe", "l6-pipe", "l3-box", "l0-post", "l1-post"})
    EXPECT_FALSE(has(names, pair)) << pair;
}

TEST(PartLink, AnObjectMayTouchWhatCarriesItAndWhatThatHangsOn) {
  const TemporaryFolder folder;
  const auto robot = std::make_shared<const Robot>(load_cell(folder, "l6"));
  // Both reach through the hub: into the table l5, which carries one of them, and to the frame l4.
  const Shape through{Cylinder{0.05, 0.4}};
  const ClearanceModel clamped(robot, all_objects({{"pipe", {through}, "l5"}}));
  ASSERT_EQ(clamped.permanent_contacts().size(), 1U);
  EXPECT_EQ(clamped.permanent_contacts()[0], (ClearanceModel::Names{"l4", "pipe"}));
  EXPECT_FALSE(has(pair_names(clamped), "l5-pipe"));
  EXPECT_TRUE(has(pair_names(clamped), "l3-pipe"));
  // One that no joint connects to what it touches all the time is in the way.
  Shape round_the_hub = through;
  round_the_hub.pose.translation() = Eigen::Vector3d(1, 0, 0.35);
  const ClearanceModel standing(robot, all_objects({{"post", {round_the_hub}}}));
  EXPECT_TRUE(standing.permanent_contacts().empty());
  EXPECT_TRUE(has(pair_names(standing), "l4-post"));
}

TEST(PartLink, RefusesObjectsOnUnknownLinks) {
  const TemporaryFolder folder;
  const auto robot = std::make_shared<const Robot>(load_cell(folder, "l6"));
  const std::string message = invalid_input([&] {
    ClearanceModel(robot, all_objects({{"pipe", {{Sphere{0.02}}}, "l55"}}));
  });
  EXPECT_TRUE(says(message, "'pipe'") && says(message, "no link 'l55'")) << message;
}

TEST(PartLink, DistanceGradientsAreThoseOfNumericDifferences) {
  const TemporaryFolder folder;
  const auto robot = std::make_shared<const Robot>(load_cell(folder, "l6"));
  const auto model = std::make_shared<const ClearanceModel>(
      robot,
      all_objects(
          {{"post", {{Sphere{0.02}, Pose(Eigen::Translation3d(0.6, 0.5, 0.4))}}},
           {"pipe", {{Cylinder{0.04, 0.3}, Pose(Eigen::Translation3d(0.1, 0, 0.2))}}, "l5"}}));
  ClearanceChecker checker(model);
  Random random(5);
  const double h = 1e-6;
  int compared = 0;
  for (int k = 0; k < 20; ++k) {
    const JointVector q = posture(*robot, random);
    for (std::size_t i = 0; i < model->pairs().size(); ++i) {
      const int pair = static_cast<int>(i);
      const auto distance = [&](const JointVector& at) {
        checker.set_posture(at);
        return checker.distance(pair).distance;
      };
      if (distance(q) < 0.01) continue;
      checker.set_posture(q);
      const JointVector gradient = checker.gradient(checker.distance(pair));
      for (int j = 0; j < robot->joint_count(); ++j, ++compared) {
        JointVector ahead = q, behind = q;
        ahead[j] += h;
        behind[j] -= h;
        EXPECT_NEAR(gradient[j], (distance(ahead) - distance(behind)) / (2 * h), 2e-5);
        EXPECT_LE(std::abs(gradient[j]), model->motion_radius(pair)[j] + 1e-9);
      }
    }
  }
  EXPECT_GT(compared, 500);
}

}  // namespace
}  // namespace wristwise
