#include "placement/standing_contacts.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "kuka_kr5_arc.hpp"

namespace wristwise {
namespace {

SceneObject box(const std::string& name, const Eigen::Vector3d& size, const Eigen::Vector3d& at) {
  return {name, {{Box{size}, pose_from_xyz_rpy(at, {0, 0, 0})}}};
}

Pose shift(double x, double y, double z) { return pose_from_xyz_rpy({x, y, z}, {0, 0, 0}); }

/// A part of 0.2 m on a table, a wall 0.3 m beside it.
PlacementRequest workshop() {
  PlacementRequest request;
  request.problem.robot = test::kr5::load();
  request.problem.scene.objects = {box("part", {0.2, 0.2, 0.2}, {1, 0, 0.5}),
                                   box("table", {1, 1, 0.4}, {1, 0, 0.2}),
                                   box("wall", {0.1, 2, 2}, {1.45, 0, 1})};
  request.options.with = {"part"};
  return request;
}

TEST(StandingContacts, APartMaySlideOnItsTableButNotSinkIntoIt) {
  const StandingContacts contacts(workshop());
  EXPECT_EQ(contacts.at(Pose::Identity()).depth, 0);
  EXPECT_EQ(contacts.at(shift(-0.2, 0.3, 0)).depth, 0);
  EXPECT_EQ(contacts.at(shift(0, 0, 0.1)).depth, 0);
  const StandingContact sunk = contacts.at(shift(0, 0, -0.02));
  EXPECT_NEAR(sunk.depth, 0.02, 1e-4);
  EXPECT_EQ(sunk.pair, Scene::Names("part", "table"));
}

TEST(StandingContacts, APartMayNotStandInAWall) {
  const StandingContacts contacts(workshop());
  EXPECT_EQ(contacts.at(shift(0.299, 0, 0)).depth, 0);
  const StandingContact inside = contacts.at(shift(0.33, 0, 0));
  EXPECT_NEAR(inside.depth, 0.03, 1e-4);
  EXPECT_EQ(inside.pair, Scene::Names("part", "wall"));
}

/// The foot of the robot never moves against the part: no plan would notice.
TEST(StandingContacts, APartMayNotStandInTheFootOfTheRobot) {
  PlacementRequest request = workshop();
  request.problem.scene.objects.erase(request.problem.scene.objects.begin() + 1);  // the table
  const StandingContact contact = StandingContacts(request).at(shift(-1, 0, -0.3));
  EXPECT_GT(contact.depth, 0.05);
  const auto& links = request.problem.robot->links();
  const auto foot = std::find_if(links.begin(), links.end(), [&](const Link& link) {
    return link.name == contact.pair.second;
  });
  ASSERT_NE(foot, links.end()) << contact.pair.second;
  EXPECT_EQ(foot->joint, -1);
}

TEST(StandingContacts, ThatTheRobotMovesIsTheSameAsThatAllElseMoves) {
  PlacementRequest request = workshop();
  request.options.placed = Placed::robot;
  request.options.with = {};
  const StandingContacts contacts(request);
  EXPECT_EQ(contacts.at(Pose::Identity()).depth, 0);
  EXPECT_GT(contacts.at(shift(-1, 0, 0)).depth, 0.05);  // the table in the robot's foot
  request.options.with = {"wall"};                      // goes with the robot
  EXPECT_GT(StandingContacts(request).at(shift(0.4, 0, 0)).depth, 0);
}

TEST(StandingContacts, OnlyWhereAllPairsCount) {
  PlacementRequest request = workshop();
  request.problem.scene.scope = CollisionScope::off;
  EXPECT_EQ(StandingContacts(request).at(shift(0.4, 0, 0)).depth, 0);
  request = workshop();
  request.problem.scene.disabled = {{"wall", "part"}};
  EXPECT_EQ(StandingContacts(request).at(shift(0.4, 0, 0)).depth, 0);
}

/// Deeper is worse, so that a search has something to go by.
TEST(StandingContacts, DepthGrowsWithTheWayIn) {
  const StandingContacts contacts(workshop());
  double last = 0;
  for (int k = 1; k <= 10; ++k) {
    const double depth = contacts.at(shift(0.3 + 0.01 * k, 0, 0)).depth;
    EXPECT_GT(depth, last);
    last = depth;
  }
}

}  // namespace
}  // namespace wristwise
