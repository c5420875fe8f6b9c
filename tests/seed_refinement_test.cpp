// Several seeds, of which the best motion is kept.

#include "refine/seed_refinement.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "cancelled.hpp"
#include "refinement_example.hpp"
#include "wristwise/verification.hpp"

namespace wristwise {
namespace {

namespace gantry = test::gantry;
using test::Example;
using test::kDuration;

constexpr double kRequired = 0.02;  // m
constexpr double kTop = 0.3;        // m, of the wall
constexpr double kHigh = 0.6;       // m, of the way over it

/// Straight along x, high and low as it likes, across a wall: 10 cm thick, down to beyond the reach
/// of the box and, to either side, of the torch. Its ends are held.
Example wall() {
  ToleranceBox box = gantry::box(0.01, 0.1);
  box.lower[2] = -0.2;
  box.upper[2] = 1;
  Example example(gantry::parts(), gantry::task({{0, 0, 0}, {1, 0, 0}}, kDuration, 40, box),
                  {gantry::obstacle(Box{{0.1, 4, 2}}, 0.5, 0, kTop - 1)}, kRequired);
  for (Waypoint* end : {&example.task.waypoints.front(), &example.task.waypoints.back()})
    end->joints = gantry::posture(end->frame.translation().x(), 0, 0);
  return example;
}

/// Along the seam, in an arch of the given height.
Seed arch(const Example& example, double height) {
  Seed seed;
  seed.path = gantry::path_along(example.task);
  for (std::size_t i = 0; i < seed.path.size(); ++i)
    seed.path.positions[i][2] = height * std::sin(std::acos(-1.0) * seed.path.times[i] / kDuration);
  return seed;
}

Refined refine_seeds(const Example& example, std::vector<Seed>& seeds, int threads = 1) {
  return refine_seeds({*example.robot, example.task, example.clearance, example.cost,
                       example.options, example.monitor},
                      seeds, threads);
}

bool same_bytes(const Trajectory& a, const Trajectory& b) {
  if (a.times() != b.times()) return false;
  for (std::size_t i = 0; i < a.times().size(); ++i) {
    for (const auto member :
         {&Trajectory::positions, &Trajectory::velocities, &Trajectory::accelerations}) {
      if (std::memcmp((a.*member)()[i].data(), (b.*member)()[i].data(), 4 * sizeof(double)) != 0)
        return false;
    }
  }
  return true;
}

/// A gradient of the clearance can't lead out of the middle of a long wall.
TEST(SeedRefinement, KeepsTheSeedThatPassesWhereTheFirstDoesNot) {
  const Example example = wall();
  std::vector<Seed> seeds = {arch(example, 0), arch(example, kHigh)};
  const Refined refined = refine_seeds(example, seeds);
  EXPECT_NE(seeds[0].refinement, "converged");
  EXPECT_NE(seeds[0].refinement, "not run");
  EXPECT_FALSE(seeds[0].objective);
  EXPECT_EQ(seeds[1].refinement, "converged");
  ASSERT_TRUE(seeds[1].objective);
  EXPECT_EQ(*seeds[1].objective, refined.statistics.objective);
  EXPECT_TRUE(refined.feasible);
  EXPECT_TRUE(verify(example.task, example.clearance, refined.trajectory).passed);
  EXPECT_TRUE(same_bytes(refined.trajectory, example.run(seeds[1].path).trajectory));
  for (double t = 4.5; t <= 5.5; t += 0.1)
    EXPECT_GE(refined.trajectory.evaluate(t)[2], kTop + kRequired + 0.05) << t;
}

TEST(SeedRefinement, TheOrderOfTheSeedsDoesNotMatterForThat) {
  const Example example = wall();
  std::vector<Seed> seeds = {arch(example, kHigh), arch(example, 0)};
  const Refined refined = refine_seeds(example, seeds);
  EXPECT_TRUE(refined.feasible);
  EXPECT_EQ(seeds[0].refinement, "converged");
  EXPECT_TRUE(seeds[0].objective);
  EXPECT_FALSE(seeds[1].objective);
}

/// Over a ball that is high, or under it, which is shorter.
TEST(SeedRefinement, KeepsTheLeastObjectiveOfThoseThatPass) {
  Example example = wall();
  example.clearance =
      gantry::clearance(example.robot, {gantry::obstacle(Sphere{0.1}, 0.5, 0, 0.08)}, kRequired);
  std::vector<Seed> seeds = {arch(example, 0.5), arch(example, -0.19)};
  const Refined refined = refine_seeds(example, seeds);
  ASSERT_TRUE(seeds[0].objective && seeds[1].objective);
  EXPECT_LT(*seeds[1].objective, 0.9 * *seeds[0].objective);
  EXPECT_EQ(refined.statistics.objective, *seeds[1].objective);
  EXPECT_LT(refined.trajectory.evaluate(kDuration / 2)[2], 0);
}

TEST(SeedRefinement, GivesTheSameBytesWithAnyNumberOfThreads) {
  const Example example = wall();
  std::vector<Seed> first;
  for (const double height : {0.0, 0.5, kHigh, 0.7}) first.push_back(arch(example, height));
  std::vector<Seed> seeds = first;
  const Refined one = refine_seeds(example, first, 1);
  for (const int threads : {2, 4}) {
    std::vector<Seed> again = seeds;
    const Refined other = refine_seeds(example, again, threads);
    EXPECT_TRUE(same_bytes(one.trajectory, other.trajectory));
    for (std::size_t i = 0; i < seeds.size(); ++i) {
      EXPECT_EQ(again[i].refinement, first[i].refinement);
      EXPECT_EQ(again[i].objective, first[i].objective);
    }
  }
}

/// The same motion mirrored: to the left of a post, to the right of it.
TEST(SeedRefinement, OfEqualsTheEarlierIsKept) {
  Refined left, right;
  for (Refined* refined : {&left, &right}) refined->feasible = true;
  left.statistics.objective = right.statistics.objective = 3;
  EXPECT_FALSE(is_better(left, right));
  EXPECT_FALSE(is_better(right, left));
  const Example example = wall();
  std::vector<Seed> seeds = {arch(example, kHigh), arch(example, kHigh), arch(example, kHigh)};
  seeds[1].path.positions[20][3] = 1e-3;  // leads to all but the same
  const Refined refined = refine_seeds(example, seeds, 2);
  ASSERT_TRUE(seeds[0].objective && seeds[2].objective);
  EXPECT_EQ(*seeds[0].objective, *seeds[2].objective);
  EXPECT_LE(refined.statistics.objective, *seeds[0].objective);
}

TEST(SeedRefinement, WhereNonePassesTheLeastViolationIsKept) {
  const Example example = wall();
  std::vector<Seed> seeds = {arch(example, -0.1), arch(example, 0)};
  const Refined refined = refine_seeds(example, seeds);
  EXPECT_FALSE(refined.feasible);
  EXPECT_FALSE(seeds[0].objective || seeds[1].objective);
  const double least = std::min(example.run(seeds[0].path).statistics.max_violation,
                                example.run(seeds[1].path).statistics.max_violation);
  EXPECT_EQ(refined.statistics.max_violation, least);
}

TEST(SeedRefinement, CancelledThrows) {
  const std::atomic<bool> cancel{true};
  Example example = wall();
  example.monitor.cancel = &cancel;
  std::vector<Seed> seeds = {arch(example, kHigh), arch(example, kHigh)};
  EXPECT_THROW(refine_seeds(example, seeds, 2), Cancelled);
}

/// A seed that is cancelled before it has a motion must not take the others' with it.
TEST(SeedRefinement, CancelledAfterOneSeedHasPassedKeepsIt) {
  std::atomic<bool> cancel{false};
  Example example = wall();
  example.monitor.cancel = &cancel;
  int reports = 0;
  std::vector<Seed> alone = {arch(example, kHigh)};
  example.monitor.progress = [&](const std::string&, double) { ++reports; };
  refine_seeds(example, alone);
  const int of_the_first = reports;
  reports = 0;
  example.monitor.progress = [&](const std::string&, double) {
    if (++reports == of_the_first + 1) cancel = true;
  };
  std::vector<Seed> seeds = {arch(example, kHigh), arch(example, 0)};
  const Refined refined = refine_seeds(example, seeds);
  EXPECT_TRUE(refined.feasible);
  EXPECT_TRUE(seeds[0].objective);
  EXPECT_FALSE(seeds[1].objective);
}

}  // namespace
}  // namespace wristwise
