#include "graph/distinct_paths.hpp"

#include <gtest/gtest.h>

#include "graph_planning.hpp"

namespace wristwise {
namespace {

namespace gantry = test::gantry;
using gantry::Planning;

/// A post in the middle of the seam, a little to one side: the best path passes it on the other one.
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

TEST(DistinctPaths, DifferByTheSeparationAndComeInTheOrderOfCost) {
  Planning planning = past_a_post(0.06);
  planning.options.seeds = 5;
  const GraphPlan plan = planning.plan();
  ASSERT_GE(plan.seeds.size(), 4U);
  for (std::size_t a = 0; a < plan.seeds.size(); ++a) {
    if (a > 0) {
      EXPECT_LE(plan.seeds[a - 1].cost, plan.seeds[a].cost);
    }
    for (std::size_t b = 0; b < a; ++b) {
      double farthest = 0;
      for (std::size_t i = 0; i < plan.seeds[a].path.size(); ++i) {
        farthest = std::max(farthest, (plan.seeds[a].path.positions[i] -
                                       plan.seeds[b].path.positions[i])
                                          .cwiseAbs()
                                          .maxCoeff());
      }
      EXPECT_GT(farthest, 0.2) << a << ' ' << b;
    }
  }
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
