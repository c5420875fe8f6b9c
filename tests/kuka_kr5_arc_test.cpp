#include "kuka_kr5_arc.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "temporary_folder.hpp"
#include "wristwise/kinematics.hpp"

namespace wristwise {
namespace {

constexpr double kDegree = 0.017453292519943295;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

const Link& link(const Robot& robot, const std::string& name) {
  const auto found = std::find_if(robot.links().begin(), robot.links().end(),
                                  [&](const Link& candidate) { return candidate.name == name; });
  EXPECT_NE(found, robot.links().end()) << name;
  return *found;
}

TEST(KukaKr5Arc, HasTheMakersJoints) {
  const auto robot = test::kr5::load("kuka_kr5_arc.urdf");
  ASSERT_EQ(robot->joint_count(), 6);
  for (std::size_t j = 0; j < 6; ++j) {
    const Joint& joint = robot->joints()[j];
    const test::kr5::Row row = test::kr5::table()[j];
    EXPECT_EQ(joint.name, "joint_a" + std::to_string(j + 1));
    EXPECT_EQ(joint.type, JointType::revolute);
    EXPECT_EQ(joint.axis, Eigen::Vector3d::UnitZ());
    EXPECT_LT((joint.origin.matrix() - test::kr5::origin(row.xyz, row.rpy)).norm(), 1e-15);
    EXPECT_NEAR(joint.lower, row.lower_deg * kDegree, 2e-15);
    EXPECT_NEAR(joint.upper, row.upper_deg * kDegree, 2e-15);
    EXPECT_NEAR(joint.max_velocity, row.velocity_deg * kDegree, 2e-15);
    EXPECT_EQ(joint.max_acceleration, 10);
    EXPECT_EQ(joint.max_jerk, 100);
  }
  EXPECT_TRUE(robot->warnings().empty());
  const JointVector zero = JointVector::Zero(6);
  EXPECT_LT((tcp_pose(*robot, zero).matrix() - test::kr5::torch_tip(zero, 0.38)).norm(), 1e-15);
}

TEST(KukaKr5Arc, TheArmIsTheSameInBothDescriptions) {
  const auto robot = test::kr5::load("kuka_kr5_arc.urdf");
  const auto round = test::kr5::load("kuka_kr5_arc_round_torch.urdf");
  const auto arm = [](const std::string& file) {
    const std::string text =
        test::file_text(std::string(WRISTWISE_SOURCE_DIR) + "/robots/kuka_kr5_arc/" + file);
    const std::size_t begin = text.find("<!-- The arm");
    const std::size_t end = text.find("The torch is");
    EXPECT_LT(begin, end);
    return text.substr(begin, end - begin);
  };
  EXPECT_EQ(arm("kuka_kr5_arc.urdf"), arm("kuka_kr5_arc_round_torch.urdf"));
  EXPECT_EQ(robot->links().size(), round->links().size());
}

TEST(KukaKr5Arc, TheNozzleEndsBeforeTheTcp) {
  const auto robot = test::kr5::load("kuka_kr5_arc.urdf");
  const Link& torch = link(*robot, "torch");
  const Pose to_tcp = robot->tcp().inverse() * torch.pose;
  double end = -kInfinity;
  for (const Shape& shape : torch.collision) {
    const Eigen::Vector3d along = (to_tcp * shape.pose).linear().transpose().col(2);
    end = std::max(end, (to_tcp * shape.pose).translation().z() +
                            along.dot(support_point(shape.geometry, along)));
  }
  EXPECT_LT(end, -0.010);  // usual stick-outs of the wire
  EXPECT_GT(end, -0.020);
}

}  // namespace
}  // namespace wristwise
