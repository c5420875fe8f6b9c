// What find_inverse_kinematics recognises, and what it says of the arms that it does not.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "invalid_input.hpp"
#include "kuka_kr5_arc.hpp"
#include "wristwise/inverse_kinematics.hpp"

namespace wristwise {
namespace {

TEST(FindInverseKinematics, DescribesWhatItFound) {
  const InverseKinematicsFound found = find_inverse_kinematics(test::kr5::load());
  ASSERT_NE(found.solver, nullptr);
  EXPECT_EQ(found.description, found.solver->description());
  for (const char* part : {"spherical wrist, closed form", "0.18 m", "0.6 m", "0.6315 m"}) {
    EXPECT_TRUE(test::says(found.description, part)) << found.description;
  }
}

TEST(FindInverseKinematics, SaysWhichConditionFails) {
  const auto ideal = test::kr5::load();
  const auto refusal = [&](const std::function<void(Robot::Parts&)>& change) {
    Robot::Parts parts;
    parts.name = "changed";
    parts.joints = ideal->joints();
    parts.tcp = ideal->tcp();
    change(parts);
    const auto found = find_inverse_kinematics(std::make_shared<const Robot>(parts));
    EXPECT_TRUE(found.solver && test::says(found.description, "numeric")) << found.description;
    return found.description;
  };
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX();
  EXPECT_TRUE(test::says(refusal([](auto& p) { p.joints.pop_back(); }), "5 movable joints"));
  EXPECT_TRUE(test::says(refusal([](auto& p) { p.joints[3].type = JointType::prismatic; }),
                         "joint 'joint_a4' is prismatic"));
  EXPECT_TRUE(test::says(refusal([&](auto& p) {
                           p.joints[2].axis = Eigen::AngleAxisd(0.1, x) * Eigen::Vector3d::UnitZ();
                         }),
                         "axes 2 and 3 are 5.73 deg from parallel"));
  EXPECT_TRUE(test::says(
      refusal([&](auto& p) { p.joints[4].origin.translation() += Eigen::Vector3d(0, 0.05, 0); }),
      "do not meet"));
  EXPECT_TRUE(test::says(refusal([](auto& p) {
                           p.joints[0].axis =
                               p.joints[0].origin.linear().transpose() * Eigen::Vector3d::UnitY();
                         }),
                         "axes 1 and 2 are parallel"));
  EXPECT_TRUE(test::says(refusal([](auto& p) { p.joints[2].origin.translation().setZero(); }),
                         "axes 2 and 3 are only"));
}

TEST(FindInverseKinematics, RefusesSenselessArguments) {
  test::invalid_input([] { find_inverse_kinematics(nullptr); });
  test::invalid_input([] { find_inverse_kinematics(test::kr5::load(), NAN); });
  test::invalid_input([] { find_inverse_kinematics(test::kr5::load(), -1); });
}

}  // namespace
}  // namespace wristwise
