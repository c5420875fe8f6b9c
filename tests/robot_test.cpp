#include "wristwise/robot.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "wristwise/error.hpp"

namespace wristwise {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Joint make_joint(const std::string& name) {
  Joint joint;
  joint.name = name;
  joint.axis = Eigen::Vector3d(0, 3, 4);
  joint.lower = -1;
  joint.upper = 2;
  joint.max_velocity = 3;
  joint.max_acceleration = 4;
  joint.max_jerk = kInfinity;
  return joint;
}

Robot::Parts make_parts() {
  Robot::Parts parts;
  parts.name = "test";
  parts.joints = {make_joint("a"), make_joint("b")};
  parts.links = {{"base", -1, Pose::Identity(), {}}, {"arm", 0, Pose::Identity(), {}}};
  parts.adjacent_links = {{0, 1}};
  return parts;
}

TEST(Robot, NormalisesAxesAndGathersLimits) {
  const Robot robot(make_parts());
  EXPECT_EQ(robot.joint_count(), 2);
  EXPECT_NEAR((robot.joints()[0].axis - Eigen::Vector3d(0, 0.6, 0.8)).norm(), 0, 1e-15);
  EXPECT_EQ(robot.lower_limits(), JointVector::Constant(2, -1));
  EXPECT_EQ(robot.upper_limits(), JointVector::Constant(2, 2));
  EXPECT_EQ(robot.velocity_limits(), JointVector::Constant(2, 3));
  EXPECT_EQ(robot.acceleration_limits(), JointVector::Constant(2, 4));
  EXPECT_EQ(robot.jerk_limits(), JointVector::Constant(2, kInfinity));
}

TEST(Robot, AcceptsALockedJointAndAContinuousOne) {
  Robot::Parts parts = make_parts();
  parts.joints[0].lower = parts.joints[0].upper = 0.5;
  parts.joints[1].type = JointType::continuous;
  parts.joints[1].lower = -kInfinity;
  parts.joints[1].upper = kInfinity;
  EXPECT_NO_THROW(Robot{parts});
}

struct Fault {
  std::string name;
  std::function<void(Robot::Parts&)> plant;
  std::string told;  // what the message must say
};

class RobotFaults : public testing::TestWithParam<Fault> {};

TEST_P(RobotFaults, AreRefusedByName) {
  Robot::Parts parts = make_parts();
  GetParam().plant(parts);
  try {
    const Robot robot(parts);
    FAIL() << "was accepted";
  } catch (const InvalidInput& error) {
    EXPECT_NE(std::string(error.what()).find(GetParam().told), std::string::npos) << error.what();
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, RobotFaults,
    testing::Values(
        Fault{"NoJoints", [](auto& p) { p.joints.clear(); }, "0 movable joints"},
        Fault{"TooManyJoints",
              [](auto& p) {
                p.joints.clear();
                for (int j = 0; j <= kMaxJoints; ++j) {
                  p.joints.push_back(make_joint("j" + std::to_string(j)));
                }
              },
              "17 movable joints"},
        Fault{"DuplicateJoint", [](auto& p) { p.joints[1].name = "a"; }, "'a': the name"},
        Fault{"ZeroAxis", [](auto& p) { p.joints[1].axis.setZero(); }, "joint 'b'"},
        Fault{"NanAxis", [](auto& p) { p.joints[1].axis.x() = NAN; }, "joint 'b'"},
        Fault{"NanOrigin", [](auto& p) { p.joints[0].origin.translation().x() = NAN; }, "'a'"},
        Fault{"ShearedOrigin", [](auto& p) { p.joints[0].origin.matrix()(0, 1) = 0.1; }, "'a'"},
        Fault{"MirroredOrigin", [](auto& p) { p.joints[0].origin.matrix()(2, 2) = -1; }, "'a'"},
        Fault{"InvertedLimits", [](auto& p) { p.joints[1].lower = 3; }, "exceeds upper"},
        Fault{"NanLimit", [](auto& p) { p.joints[1].upper = NAN; }, "NaN"},
        Fault{"UnboundedRevolute", [](auto& p) { p.joints[1].upper = kInfinity; }, "joint 'b'"},
        Fault{"BoundedContinuous", [](auto& p) { p.joints[1].type = JointType::continuous; },
              "joint 'b'"},
        Fault{"ZeroVelocity", [](auto& p) { p.joints[1].max_velocity = 0; }, "max_velocity"},
        Fault{"NanAcceleration", [](auto& p) { p.joints[1].max_acceleration = NAN; },
              "max_acceleration"},
        Fault{"NegativeJerk", [](auto& p) { p.joints[1].max_jerk = -1; }, "max_jerk"},
        Fault{"LinkOnNoJoint", [](auto& p) { p.links[1].joint = 2; }, "link 'arm'"},
        Fault{"DuplicateLink", [](auto& p) { p.links[1].name = "base"; }, "link 'base'"},
        Fault{"NanLink", [](auto& p) { p.links[1].pose.translation().z() = NAN; }, "link 'arm'"},
        Fault{"NanShape",
              [](auto& p) {
                Shape shape{Sphere{0.1}, Pose::Identity()};
                shape.pose.translation().y() = NAN;
                p.links[1].collision.push_back(shape);
              },
              "link 'arm'"},
        Fault{"AdjacentToNothing",
              [](auto& p) {
                p.adjacent_links = {{0, 2}};
              },
              "adjacent"},
        Fault{"NanTool", [](auto& p) { p.tcp.translation().x() = NAN; }, "tool"}),
    [](const auto& instance) { return instance.param.name; });

}  // namespace
}  // namespace wristwise
