#include "published_arms.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "random_arm.hpp"
#include "wristwise/clearance.hpp"

namespace wristwise {
namespace {

constexpr double kDegree = 0.017453292519943295;

JointVector radians(const std::vector<double>& degrees) {
  return kDegree * Eigen::Map<const Eigen::VectorXd>(degrees.data(),
                                                     static_cast<Eigen::Index>(degrees.size()));
}

JointVector random_posture(const Robot& robot, test::Dice& dice) {
  JointVector q(robot.joint_count());
  for (int j = 0; j < robot.joint_count(); ++j)
    q[j] = dice.uniform(robot.lower_limits()[j], robot.upper_limits()[j]);
  return q;
}

class PublishedArm : public testing::TestWithParam<test::PublishedArm> {
 protected:
  ClearanceChecker checker(const Scene& scene = {}) const {
    return ClearanceChecker(std::make_shared<const ClearanceModel>(robot_, scene));
  }

  std::shared_ptr<const Robot> robot_ = GetParam().load();
};

TEST_P(PublishedArm, HasTheMakersRangesAndSpeeds) {
  EXPECT_EQ(robot_->name(), GetParam().name);
  EXPECT_TRUE(robot_->warnings().empty());
  ASSERT_EQ(robot_->joints().size(), GetParam().joints.size());
  for (std::size_t j = 0; j < robot_->joints().size(); ++j) {
    const Joint& joint = robot_->joints()[j];
    const test::PublishedJoint& published = GetParam().joints[j];
    EXPECT_EQ(joint.name, published.name);
    EXPECT_EQ(joint.type, JointType::revolute);
    EXPECT_NEAR(joint.lower, -published.range_deg * kDegree, 2e-15);
    EXPECT_NEAR(joint.upper, published.range_deg * kDegree, 2e-15);
    EXPECT_NEAR(joint.max_velocity, published.speed_deg * kDegree, 2e-15);
    EXPECT_EQ(joint.max_acceleration, 10);
    EXPECT_EQ(joint.max_jerk, 100);
  }
}

TEST_P(PublishedArm, HasTheMakersKinematics) {
  test::Dice dice(1);
  for (int i = 0; i < 1000; ++i) {
    const JointVector q = random_posture(*robot_, dice);
    const Eigen::Matrix4d tip =
        GetParam().flange(q) * test::kr5::turn(1, 45 * kDegree) * test::kr5::shift({0, 0, 0.38});
    ASSERT_LT((tcp_pose(*robot_, q).matrix() - tip).cwiseAbs().maxCoeff(), 1e-12);
  }
}

TEST_P(PublishedArm, IsClearOfItselfInItsUsualPostures) {
  ClearanceChecker checker = this->checker();
  for (const std::vector<double>& degrees : GetParam().usual_postures_deg) {
    checker.set_posture(radians(degrees));
    const auto nearest = checker.nearest();
    ASSERT_TRUE(nearest.has_value());
    const ClearanceModel::Names names = checker.model().names(nearest->pair);
    EXPECT_GT(nearest->distance, 0.02) << names.first << " - " << names.second;
  }
}

/// The seven-axis arm is narrow and turns so little that it hardly reaches itself; the other one
/// runs into itself wherever its elbow is folded.
TEST_P(PublishedArm, TouchesItselfInAPlausibleShareOfItsPostures) {
  ClearanceChecker checker = this->checker();
  EXPECT_TRUE(checker.model().permanent_contacts().empty());
  test::Dice dice(2);
  constexpr int kPostures = 20000;
  int touching = 0;
  for (int i = 0; i < kPostures; ++i) {
    checker.set_posture(random_posture(*robot_, dice));
    if (checker.first_below(0)) ++touching;
  }
  const double share = double(touching) / kPostures;
  EXPECT_GT(share, GetParam().least_share_touching);
  EXPECT_LT(share, GetParam().largest_share_touching);
}

/// The arm has no gaps: bodies that follow one another stay within 2 cm, wherever it moves.
TEST_P(PublishedArm, ItsBodiesHoldTogether) {
  std::vector<std::string> bodies;
  for (const Link& link : robot_->links())
    if (!link.collision.empty()) bodies.push_back(link.name);
  ASSERT_EQ(bodies.size(), static_cast<std::size_t>(robot_->joint_count()) + 2);
  Scene scene;
  scene.scope = CollisionScope::pairs;
  // The last body, the torch, does not move against the one before it.
  for (std::size_t i = 0; i + 2 < bodies.size(); ++i)
    scene.pairs.emplace_back(bodies[i], bodies[i + 1]);
  ClearanceChecker checker = this->checker(scene);
  test::Dice dice(3);
  for (int i = 0; i < 200; ++i) {
    checker.set_posture(random_posture(*robot_, dice));
    std::map<ClearanceModel::Names, double> distance;
    for (int pair = 0; pair < static_cast<int>(checker.model().pairs().size()); ++pair) {
      const double measured = checker.distance(pair).distance;
      const auto [entry, added] = distance.emplace(checker.model().names(pair), measured);
      if (!added) entry->second = std::min(entry->second, measured);
    }
    ASSERT_EQ(distance.size(), scene.pairs.size());
    for (const auto& [names, least] : distance)
      EXPECT_LT(least, 0.02) << names.first << " - " << names.second;
  }
}

INSTANTIATE_TEST_SUITE_P(Shipped, PublishedArm,
                         testing::Values(test::offset_wrist_arm(), test::seven_axis_arm()),
                         [](const auto& arm) { return arm.param.name; });

}  // namespace
}  // namespace wristwise
