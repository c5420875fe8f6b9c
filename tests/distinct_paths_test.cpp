#include "graph/distinct_paths.hpp"

#include <gtest/gtest.h>

#include <set>

#include "graph_planning.hpp"

namespace wristwise {
namespace {

namespace gantry = test::gantry;
using gantry::Planning;

/// A post in the middle of the seam, a little to one side: the best path passes it on the other
/// one.
Planning past_a_post(double y) {
  Planning planning;
  planning.allow(1, 0.4, 0.05);
  planning.objects = {gantry::obstacle(Cylinder{0.1, 4}, 0.5, y, 0)};
  planning.options.max_stray = gantry::kUnlimited;
  planning.options.seed_separation = 0.2;
  planning.pull_to_seam(0.1);
  return planning;
}

TEST(DistinctPaths, PassTheObstacleOnBothSides) {
  for (const double y : {-0.06, 0.06}) {
    Planning planning = past_a_post(y);
    planning.options.seeds = 4;
    const GraphPlan plan = planning.plan();
    ASSERT_TRUE(plan.found);
    EXPECT_LT((plan.seeds[0].path.positions[10][1] - y) * y, 0);
    bool both = false;
    for (const Seed& seed : plan.seeds) {
      const double side = seed.path.positions[10][1] - y;
      EXPECT_GE(std::abs(side), 0.15 - 1e-9);
      both = both || side * y > 0;
    }
    EXPECT_TRUE(both);
  }
}

/// Two posts in a row: left or right of each.
TEST(DistinctPaths, ComeInTheOrderOfCost) {
  Planning planning = past_a_post(0.06);
  planning.objects[0].shapes[0].pose.translation().x() = 0.25;
  planning.objects.push_back(gantry::obstacle(Cylinder{0.1, 4}, 0.75, -0.05, 0));
  planning.objects[1].name = "second";
  planning.options.seeds = 5;
  const GraphPlan plan = planning.plan();
  ASSERT_GE(plan.seeds.size(), 3U);
  std::set<std::pair<bool, bool>> sides;
  for (std::size_t k = 0; k < plan.seeds.size(); ++k) {
    const auto& q = plan.seeds[k].path.positions;
    sides.insert({q[5][1] > 0.06, q[15][1] > -0.05});
    if (k > 0) {
      EXPECT_LE(plan.seeds[k - 1].cost, plan.seeds[k].cost);
    }
  }
  EXPECT_EQ(sides.size(), plan.seeds.size());
}

TEST(Regions, AreWhatNeighboursJoin) {
  Rung rung;
  rung.positions.resize(6, 2);
  rung.positions << 0, 3.1, 0.1, -3.1, 0.2, 3.0, 0.5, 3.0, 0.6, 3.0, 0.3, 3.0;
  rung.cost.setZero(6);
  JointVector period(2);
  period << gantry::kUnlimited, 2 * std::acos(-1.0);
  const std::vector<int> region =
      find_regions(rung, period, 0.15, {true, true, true, true, true, false});
  EXPECT_EQ(region[0], region[1]);  // across the seam of the circle
  EXPECT_NE(region[1], region[2]);
  EXPECT_EQ(region[3], region[4]);
  EXPECT_NE(region[2], region[3]);
  EXPECT_EQ(region[5], -1);
}

TEST(DistinctPaths, AreFewerWhereThereIsNoOtherWay) {
  Planning planning;
  planning.options.seeds = 3;
  const GraphPlan plan = planning.plan();
  EXPECT_TRUE(plan.found);
  EXPECT_EQ(plan.seeds.size(), 1U);
}

TEST(DistinctPaths, DoNotDependOnTheNumberOfThreads) {
  Planning planning = past_a_post(0.06);
  planning.options.seeds = 4;
  const GraphPlan one = planning.plan(1), three = planning.plan(3);
  ASSERT_EQ(one.seeds.size(), three.seeds.size());
  for (std::size_t k = 0; k < one.seeds.size(); ++k) {
    EXPECT_EQ(one.seeds[k].cost, three.seeds[k].cost);
    for (std::size_t i = 0; i < one.seeds[k].path.size(); ++i) {
      EXPECT_EQ(one.seeds[k].path.positions[i], three.seeds[k].path.positions[i]);
    }
  }
}

}  // namespace
}  // namespace wristwise
