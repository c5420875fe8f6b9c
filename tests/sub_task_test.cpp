#include "graph/sub_task.hpp"

#include <gtest/gtest.h>

#include "graph_planning.hpp"

namespace wristwise {
namespace {

namespace gantry = test::gantry;
using gantry::Planning;

TEST(SubTask, HasTheWaypointsAskedForAndTheirCosts) {
  Planning planning;
  planning.cost.vertex_cost = [](std::size_t waypoint, const JointVector&) {
    return static_cast<double>(waypoint);
  };
  planning.cost.edge_cost = [](std::size_t waypoint, const JointVector&, const JointVector&) {
    return 100.0 + static_cast<double>(waypoint);
  };
  const SubTask some = sub_task(planning.task, planning.cost, {2, 5, 9});
  ASSERT_EQ(some.task.waypoints.size(), 3U);
  EXPECT_EQ(some.task.waypoints[1].time, planning.task.waypoints[5].time);
  const JointVector q = gantry::posture(0, 0, 0);
  EXPECT_EQ(some.cost.vertex_cost(2, q), 9);
  EXPECT_EQ(some.cost.edge_cost(1, q, q), 105);
  const SubTask run = sub_task(planning.task, planning.cost, 4, 7);
  ASSERT_EQ(run.task.waypoints.size(), 3U);
  EXPECT_EQ(run.cost.vertex_cost(0, q), 4);
  EXPECT_FALSE(sub_task(planning.task, {}, 4, 7).cost.vertex_cost);
}

/// Waypoint i is at x = 0.05 i, or up to 0.03 m off where wider tolerances are tried: wherever a
/// cost is asked for, posture and waypoint belong together.
constexpr double kWidest = 0.031;

TEST(SubTask, CostsOfOnesOwnAreToldTheWaypointWhateverIsPlanned) {
  for (const bool sparse : {false, true}) {
    for (const bool blocked : {false, true}) {
      Planning planning;
      planning.allow(1, 0.1, 0.05);
      planning.options.planner = sparse ? Planner::sparse : Planner::dense;
      planning.options.coarse_to_fine = !sparse;
      planning.options.seeds = 2;
      if (blocked) planning.objects = {gantry::obstacle(Cylinder{0.1, 4}, 0.5, 0, 0)};
      std::size_t asked = 0, wrong = 0;
      planning.cost.vertex_cost = [&](std::size_t waypoint, const JointVector& q) {
        ++asked;
        if (std::abs(q[0] - 0.05 * static_cast<double>(waypoint)) > kWidest) ++wrong;
        return 0.1 * std::abs(q[1]);
      };
      planning.cost.edge_cost = [&](std::size_t waypoint, const JointVector& from,
                                    const JointVector&) {
        ++asked;
        if (std::abs(from[0] - 0.05 * static_cast<double>(waypoint)) > kWidest) ++wrong;
        return 0.0;
      };
      EXPECT_EQ(planning.plan(1).found, !blocked);
      EXPECT_GT(asked, 50U);
      EXPECT_EQ(wrong, 0U) << sparse << blocked;
    }
  }
}

}  // namespace
}  // namespace wristwise
