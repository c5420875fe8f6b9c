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

constexpr double kRequired = 0.02;                              // m
constexpr double kRadius = 0.25, kHeight = 0.05;                // m, of the pipe and its axis
constexpr double kOver = kHeight + kRadius + 0.05 + kRequired;  // m, least height of the ball there
constexpr double kUnder = kHeight - kRadius - 0.05 - kRequired;  // m, largest

/// Straight along x, as high and low as it likes from `lowest` on, across a thick pipe that lies
/// from beyond its reach to beyond its reach on the other side. Its ends are held.
Example pipe(double lowest = -0.2) {
  ToleranceBox box = gantry::box(0.01, 0.1);
  box.lower[2] = lowest;
  box.upper[2] = 1;
  SceneObject along_y = gantry::obstacle(Cylinder{kRadius, 6}, 0.5, 0, kHeight);
  along_y.shapes[0].pose.rotate(Eigen::AngleAxisd(std::acos(0.0), Eigen::Vector3d::UnitX()));
  Example example(gantry::parts(), gantry::task({{0, 0, 0}, {1, 0, 0}}, kDuration, 40, box),
                  {along_y}, kRequired);
  for (Waypoint* end : {&example.task.waypoints.front(), &example.task.waypoints.back()})
    end->joints = gantry::posture(end->frame.translation().x(), 0, 0);
  return example;
}

constexpr double kHigh = 0.6;  // m, of the way over it

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

/// Straight through the pipe, below its axis: the way out is down, where the box ends.
TEST(SeedRefinement, KeepsTheSeedThatPassesWhereTheFirstDoesNot) {
  const Example example = pipe();
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
  EXPECT_GE(refined.trajectory.evaluate(kDuration / 2)[2], kOver - 1e-3);
}

TEST(SeedRefinement, TheOrderOfTheSeedsDoesNotMatterForThat) {
  const Example example = pipe();
  std::vector<Seed> seeds = {arch(example, kHigh), arch(example, 0)};
  const Refined refined = refine_seeds(example, seeds);
  EXPECT_TRUE(refined.feasible);
  EXPECT_EQ(seeds[0].refinement, "converged");
  EXPECT_TRUE(seeds[0].objective);
  EXPECT_FALSE(seeds[1].objective);
}

/// The way under it is open too, and shorter.
TEST(SeedRefinement, KeepsTheLeastObjectiveOfThoseThatPass) {
  const Example example = pipe(-1);
  std::vector<Seed> seeds = {arch(example, kHigh), arch(example, -kHigh), arch(example, kHigh)};
  const Refined refined = refine_seeds(example, seeds);
  ASSERT_TRUE(seeds[0].objective && seeds[1].objective);
  EXPECT_LT(*seeds[1].objective, 0.9 * *seeds[0].objective);
  EXPECT_EQ(refined.statistics.objective, *seeds[1].objective);
  EXPECT_LE(refined.trajectory.evaluate(kDuration / 2)[2], kUnder + 1e-3);
}

TEST(SeedRefinement, GivesTheSameBytesWithAnyNumberOfThreads) {
  const Example example = pipe();
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

/// The way over the pipe and its mirror image, the way under one that is as far below the seam.
TEST(SeedRefinement, OfEqualsTheEarlierIsKept) {
  Example example = pipe(-1);
  SceneObject centred = gantry::obstacle(Cylinder{kRadius, 6}, 0.5, 0, 0);
  centred.shapes[0].pose.rotate(Eigen::AngleAxisd(std::acos(0.0), Eigen::Vector3d::UnitX()));
  example.clearance = gantry::clearance(example.robot, {centred}, kRequired);
  std::vector<Seed> seeds = {arch(example, kHigh), arch(example, kHigh)};
  const Refined refined = refine_seeds(example, seeds, 2);
  ASSERT_TRUE(seeds[0].objective && seeds[1].objective);
  EXPECT_EQ(*seeds[0].objective, *seeds[1].objective);
  EXPECT_TRUE(same_bytes(refined.trajectory, example.run(seeds[0].path).trajectory));
  // The images have the same objective but for rounding: which is kept follows from the numbers.
  for (const double first : {kHigh, -kHigh}) {
    std::vector<Seed> images = {arch(example, first), arch(example, -first)};
    const Refined image = refine_seeds(example, images, 2);
    ASSERT_TRUE(images[0].objective && images[1].objective);
    EXPECT_NEAR(*images[0].objective, *images[1].objective, 1e-6 * *images[0].objective);
    const bool first_is_kept = *images[0].objective <= *images[1].objective;
    EXPECT_EQ(image.trajectory.evaluate(kDuration / 2)[2] > 0, (first > 0) == first_is_kept);
  }
}

TEST(SeedRefinement, IsBetterIsStrict) {
  Refined one, other;
  EXPECT_FALSE(is_better(one, other));
  one.feasible = true;
  one.statistics.objective = 9;
  other.statistics.objective = 1;
  EXPECT_TRUE(is_better(one, other));
  EXPECT_FALSE(is_better(other, one));
  other.feasible = true;
  EXPECT_FALSE(is_better(one, other));
  EXPECT_TRUE(is_better(other, one));
  other.statistics.objective = 9;
  EXPECT_FALSE(is_better(one, other));
  EXPECT_FALSE(is_better(other, one));
}

TEST(SeedRefinement, WhereNonePassesTheLeastViolationIsKept) {
  const Example example = pipe();
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
  Example example = pipe();
  example.monitor.cancel = &cancel;
  std::vector<Seed> seeds = {arch(example, kHigh), arch(example, kHigh)};
  EXPECT_THROW(refine_seeds(example, seeds, 2), Cancelled);
}

/// A seed that is cancelled before it has a motion must not take the others' with it.
TEST(SeedRefinement, CancelledAfterOneSeedHasPassedKeepsIt) {
  std::atomic<bool> cancel{false};
  Example example = pipe();
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
