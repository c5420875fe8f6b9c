// Robots whose chain starts at a link that the positioner moves. The oracle multiplies the joints
// of the URDF's tree from the root down, as they are written in it, and knows no chain.

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <string>
#include <vector>

#include "invalid_input.hpp"
#include "link_tree.hpp"
#include "temporary_folder.hpp"
#include "wristwise/kinematics.hpp"
#include "wristwise/urdf.hpp"

namespace wristwise {
namespace {

using test::cell;
using test::difference;
using test::invalid_input;
using test::link_name;
using test::load_cell;
using test::named;
using test::posture;
using test::Random;
using test::says;
using test::TemporaryFolder;
using test::Tree;

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

TEST(PartLink, ThePositionersJointsComeFirstWithTheirOwnNamesAndLimits) {
  const TemporaryFolder folder;
  const Robot robot = load_cell(folder, "l6");
  const std::vector<std::string> names = robot.joint_names();
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

}  // namespace
}  // namespace wristwise
