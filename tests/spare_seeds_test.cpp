// More seeds, where none of the first can be refined; search and refinement are told by the test.

#include "refine/spare_seeds.hpp"

#include <gtest/gtest.h>

namespace wristwise {
namespace {

/// A seed that is told apart by the one value of its one posture.
Seed seed(double at) {
  Seed result;
  result.path.times = {0};
  result.path.positions = {JointVector::Constant(1, at)};
  return result;
}

double value(const Seed& of) { return of.path.positions.front()[0]; }

std::vector<double> values(const std::vector<Seed>& seeds) {
  std::vector<double> result;
  for (const Seed& one : seeds) result.push_back(value(one));
  return result;
}

Refined outcome(bool feasible, double objective, double violation = 0) {
  Refined result;
  result.feasible = feasible;
  result.statistics.objective = objective;
  result.statistics.max_violation = violation;
  return result;
}

struct SpareSeeds : testing::Test {
  std::vector<Seed> tried = {seed(1)};
  std::vector<Seed> found = {seed(1), seed(2), seed(3)};
  std::vector<std::vector<double>> refined;  ///< the seeds of each call
  Refined of_the_others = outcome(true, 5);

  Refined run(const Refined& best) {
    return try_spare_seeds(
        best, tried, [this] { return found; },
        [this](std::vector<Seed>& seeds) {
          refined.push_back(values(seeds));
          for (Seed& one : seeds) one.refinement = "told";
          return of_the_others;
        });
  }
};

TEST_F(SpareSeeds, AreRefinedWithoutThoseThatWereTried) {
  const Refined best = run(outcome(false, 1, 0.1));
  EXPECT_TRUE(best.feasible);
  EXPECT_EQ(best.statistics.objective, 5);
  EXPECT_EQ(refined, (std::vector<std::vector<double>>{{2, 3}}));
  EXPECT_EQ(values(tried), (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(tried[0].refinement, "not run");
  EXPECT_EQ(tried[1].refinement, "told");
  EXPECT_EQ(tried[2].refinement, "told");
}

/// A search that refines its grid sorts its paths by a cost that it learns last.
TEST_F(SpareSeeds, AreToldApartByTheirPathsNotByTheirPlaces) {
  tried = {seed(3), seed(1)};
  found = {seed(4), seed(1), seed(2), seed(3)};
  run(outcome(false, 1));
  EXPECT_EQ(refined, (std::vector<std::vector<double>>{{4, 2}}));
  EXPECT_EQ(values(tried), (std::vector<double>{3, 1, 4, 2}));
}

TEST_F(SpareSeeds, WhereThereAreNoneNothingIsRefined) {
  found = {seed(1)};
  const Refined best = run(outcome(false, 1, 0.1));
  EXPECT_FALSE(best.feasible);
  EXPECT_EQ(best.statistics.max_violation, 0.1);
  EXPECT_TRUE(refined.empty());
  EXPECT_EQ(values(tried), std::vector<double>{1});
}

TEST_F(SpareSeeds, TheBetterIsKeptWhereNoneCanBeRefined) {
  of_the_others = outcome(false, 9, 0.2);
  EXPECT_EQ(run(outcome(false, 1, 0.1)).statistics.max_violation, 0.1);
  tried = {seed(1)};
  of_the_others = outcome(false, 9, 0.05);
  EXPECT_EQ(run(outcome(false, 1, 0.1)).statistics.max_violation, 0.05);
}

TEST_F(SpareSeeds, AreTriedOnlyWhereTheSearchGivesSeveralAndIsCheap) {
  GraphOptions options;
  GraphStatistics search;
  search.edges_checked = 5000;
  EXPECT_TRUE(may_try_spare_seeds(options, search));
  search.edges_checked = 5001;
  EXPECT_FALSE(may_try_spare_seeds(options, search));
  search.edges_checked = 0;
  options.spare_seeds = 0;
  EXPECT_FALSE(may_try_spare_seeds(options, search));
  options.spare_seeds = 1;
  options.planner = Planner::sparse;
  EXPECT_FALSE(may_try_spare_seeds(options, search));
}

}  // namespace
}  // namespace wristwise
