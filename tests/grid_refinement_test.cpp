#include "graph/grid_refinement.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "graph_planning.hpp"

namespace wristwise {
namespace {

namespace gantry = test::gantry;
using gantry::Planning;

/// From (0, 0) to (1, 0) past a ball round (0.5, 0.1) that the gantry's ball must keep 0.2 m from,
/// with y free within 0.4 m, and drawn to the seam.
Planning past_a_ball() {
  Planning planning;
  planning.allow(1, 0.4, 0.3);
  planning.objects = {gantry::obstacle(Sphere{0.1}, 0.5, 0.1, 0)};
  planning.required = 0.05;
  planning.options.max_stray = gantry::kUnlimited;
  planning.pull_to_seam(0.05);
  return planning;
}

TEST(CoarseToFine, LowersTheCostToWhatAFineGridGives) {
  Planning planning = past_a_ball();
  const double coarse = planning.plan().statistics.cost;
  planning.options.coarse_to_fine = true;
  const GraphPlan finer = planning.plan();
  planning.options.coarse_to_fine = false;
  planning.allow(1, 0.4, 0.002);
  const double fine = planning.plan().statistics.cost;
  ASSERT_TRUE(finer.found);
  EXPECT_GT(finer.statistics.grid_rounds, 3);
  EXPECT_DOUBLE_EQ(finer.statistics.first_cost, coarse);
  EXPECT_LT(finer.statistics.cost, coarse);
  EXPECT_NEAR(finer.statistics.cost, fine, 0.02 * fine);
}

TEST(CoarseToFine, StaysInTheBox) {
  Planning planning = past_a_ball();
  planning.options.coarse_to_fine = true;
  for (Waypoint& waypoint : planning.task.waypoints) waypoint.tolerance.upper[1] = 0.01;
  const GraphPlan plan = planning.plan();
  ASSERT_TRUE(plan.found);
  for (std::size_t i = 0; i < plan.seeds.front().path.size(); ++i) {
    const JointVector& q = plan.seeds.front().path.positions[i];
    EXPECT_GE(q[1], -0.4 - 1e-12);
    EXPECT_LE(q[1], 0.01 + 1e-12);
    EXPECT_EQ(q[2], 0);
    EXPECT_NEAR(q[0], 0.05 * static_cast<double>(i), 1e-12);
  }
}

/// Where nothing is sampled there is nothing to refine.
TEST(CoarseToFine, LeavesAFixedPathAlone) {
  Planning planning;
  const double cost = planning.plan().statistics.cost;
  planning.options.coarse_to_fine = true;
  EXPECT_DOUBLE_EQ(planning.plan().statistics.cost, cost);
}

}  // namespace
}  // namespace wristwise
