// Objects that stand in the base, or move with a link of the arm or of the positioner.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "invalid_input.hpp"
#include "link_tree.hpp"
#include "temporary_folder.hpp"
#include "wristwise/clearance.hpp"
#include "wristwise/kinematics.hpp"

namespace wristwise {
namespace {

using test::cell;
using test::difference;
using test::invalid_input;
using test::load_cell;
using test::named;
using test::posture;
using test::Random;
using test::says;
using test::TemporaryFolder;
using test::Tree;

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

TEST(ObjectLink, ObjectsStandInTheBaseOrMoveWithTheirLink) {
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

TEST(ObjectLink, AnObjectMayTouchWhatCarriesItAndWhatThatHangsOn) {
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

TEST(ObjectLink, RefusesObjectsOnUnknownLinks) {
  const TemporaryFolder folder;
  const auto robot = std::make_shared<const Robot>(load_cell(folder, "l6"));
  const std::string message = invalid_input([&] {
    ClearanceModel(robot, all_objects({{"pipe", {{Sphere{0.02}}}, "l55"}}));
  });
  EXPECT_TRUE(says(message, "'pipe'") && says(message, "no link 'l55'")) << message;
}

TEST(ObjectLink, DistanceGradientsAreThoseOfNumericDifferences) {
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
