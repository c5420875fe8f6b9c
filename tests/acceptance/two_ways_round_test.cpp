// A scene whose cheapest path of stage 1 lies in a homotopy class that no motion can follow at weld
// speed: it weaves between three jaws faster than the joints can accelerate. Another class can be
// followed. On which side of a jaw the torch passes is the test's own forward kinematics.

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "io/result_file.hpp"
#include "kuka_kr5_arc.hpp"
#include "wristwise/wristwise.hpp"

namespace wristwise {
namespace {

constexpr double kTorch = 0.38, kNozzle = 0.009;               // m
constexpr double kSeamX = 0.82, kSeamZ = 0.27, kStart = -0.3;  // m
constexpr double kSpeed = 0.15;                                // m/s

struct Jaw {
  double x, y;
};
constexpr double kHalfWidth = 0.015, kHalfHeight = 0.01, kJawZ = 0.335;  // m
constexpr Jaw kJaws[] = {{0.807, -0.068}, {0.836, 0}, {0.807, 0.068}};

Problem two_ways_round() {
  return load_problem(std::string(WRISTWISE_SOURCE_DIR) + "/problems/two_ways_round.yaml");
}

/// x (m) of the torch's axis at a height.
double axis_x(const JointVector& q, double z) {
  const Eigen::Matrix4d tip = test::kr5::torch_tip(q, kTorch);
  return tip(0, 3) + tip(0, 2) / tip(2, 2) * (z - tip(2, 3));
}

/// On which side of each jaw the torch passes: '+' or '-' along x.
template <class PostureAt>
std::string sides(const PostureAt& posture_at, double speed = kSpeed) {
  std::string result;
  for (const Jaw& jaw : kJaws) {
    const double x = axis_x(posture_at((jaw.y - kStart) / speed), kJawZ);
    result += x > jaw.x ? '+' : '-';
  }
  return result;
}

std::string sides(const Trajectory& motion, double speed = kSpeed) {
  return sides([&](double t) { return motion.evaluate(t); }, speed);
}

std::string sides(const JointPath& path) {
  return sides([&](double t) {
    std::size_t nearest = 0;
    for (std::size_t i = 0; i < path.size(); ++i) {
      if (std::abs(path.times[i] - t) < std::abs(path.times[nearest] - t)) nearest = i;
    }
    return path.positions[nearest];
  });
}

const std::string kWeave = "+-+", kLean = "+++";

PlanResult plan_with(int seeds, int spare, int threads = 0) {
  Problem problem = two_ways_round();
  problem.graph.seeds = seeds;
  problem.graph.spare_seeds = spare;
  problem.refine.try_speeds = false;
  PlanOptions options;
  options.threads = threads;
  return plan(problem, options);
}

/// One seed by default, and the spare ones. On one thread.
const PlanResult& with_spare_seeds() {
  static const PlanResult result = plan_with(1, 3, 1);
  return result;
}

/// Those that lean can be refined, the cheapest one, which weaves, can't; of each kind there is one
/// for each way to hold the wrist.
void expect_lean(const PlanResult& result, std::size_t seeds) {
  ASSERT_EQ(result.status, Status::solved);
  EXPECT_EQ(sides(result.trajectory), kLean);
  ASSERT_EQ(result.seeds.size(), seeds);
  EXPECT_EQ(sides(result.seeds.front().path), kWeave);
  EXPECT_FALSE(result.seeds.front().objective);
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < seeds; ++k) {
    const Seed& seed = result.seeds[k];
    if (k > 0) {
      EXPECT_GE(seed.cost, result.seeds[k - 1].cost);
    }
    if (sides(seed.path) == kLean) {
      EXPECT_TRUE(seed.objective);
    }
    EXPECT_EQ(seed.refinement == "converged", seed.objective.has_value());
    if (seed.objective) least = std::min(least, *seed.objective);
  }
  EXPECT_EQ(result.refine.objective, least);
}

TEST(TwoWaysRound, TheCheapestPathAloneIsTooQuick) {
  const PlanResult result = plan_with(1, 0);
  EXPECT_EQ(result.status, Status::infeasible);
  ASSERT_EQ(result.seeds.size(), 1U);
  EXPECT_EQ(sides(result.seeds.front().path), kWeave);
  EXPECT_FALSE(result.seeds.front().objective);
  ASSERT_FALSE(result.diagnosis.empty());
  EXPECT_EQ(result.diagnosis.front().reason, "infeasible_at_this_speed");
  EXPECT_GT(result.verification.acceleration_ratio, 1.5);
}

TEST(TwoWaysRound, OfThreeSeedsTheOneThatCanBeFollowedIsKept) {
  const PlanResult result = plan_with(3, 0);
  expect_lean(result, 3);

  PlanOptions dense;
  dense.verification.samples_per_interval = 50;
  EXPECT_TRUE(check(two_ways_round(), result.trajectory, dense).passed);
  const double end = result.trajectory.times().back();
  for (double t = 0; t < end; t += 1e-3) {
    const JointVector q = result.trajectory.evaluate(t);
    EXPECT_LE(result.trajectory.evaluate(t, 2).cwiseAbs().maxCoeff(), 10);
    EXPECT_LE(result.trajectory.evaluate(t, 3).cwiseAbs().maxCoeff(), 100);
    const Eigen::Matrix4d tip = test::kr5::torch_tip(q, kTorch);
    EXPECT_LT(
        (tip.topRightCorner<3, 1>() - Eigen::Vector3d(kSeamX, kStart + kSpeed * t, kSeamZ)).norm(),
        2e-4);
    // Beside a jaw the nozzle keeps off its sides, all along its height.
    for (const Jaw& jaw : kJaws) {
      if (std::abs(tip(1, 3) - jaw.y) > kHalfWidth) continue;
      const double half_length = jaw.y == 0 ? 0.009 : 0.006;
      for (const double z : {kJawZ - kHalfHeight, kJawZ, kJawZ + kHalfHeight})
        EXPECT_GE(std::abs(axis_x(q, z) - jaw.x), half_length + kNozzle + 0.002 - 1e-6);
    }
  }
}

/// The same as where they are asked for at once, with any number of threads.
TEST(TwoWaysRound, SpareSeedsFindIt) {
  const PlanResult& spare = with_spare_seeds();
  expect_lean(spare, 4);
  const PlanResult asked = plan_with(4, 0, 2);
  EXPECT_EQ(spare.trajectory.positions(), asked.trajectory.positions());
  ASSERT_EQ(asked.seeds.size(), spare.seeds.size());
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_EQ(spare.seeds[k].path.positions, asked.seeds[k].path.positions);
    EXPECT_EQ(spare.seeds[k].refinement, asked.seeds[k].refinement);
    EXPECT_EQ(spare.seeds[k].objective, asked.seeds[k].objective);
  }
}

TEST(TwoWaysRound, TheResultFileSaysWhatEachSeedGave) {
  const PlanResult& result = with_spare_seeds();
  const auto json = nlohmann::json::parse(result_json(result, two_ways_round()));
  EXPECT_EQ(json.at("status"), "solved");
  const auto& seeds = json.at("graph").at("seeds");
  ASSERT_EQ(seeds.size(), 4U);
  EXPECT_EQ(seeds[0].at("cost"), result.seeds[0].cost);
  EXPECT_TRUE(seeds[0].at("objective").is_null());
  EXPECT_NE(seeds[0].at("refinement"), "converged");
  EXPECT_NE(seeds[0].at("refinement"), "not run");
  EXPECT_TRUE(seeds[3].at("objective").is_number());
  EXPECT_EQ(seeds[3].at("refinement"), "converged");
  EXPECT_EQ(seeds[3].at("differs_at"), 60);
}

/// Neither the jaws nor the tolerance are in the way of the weave, but the speed is.
TEST(TwoWaysRound, SlowlyTheCheapestPathDoesAsWell) {
  Problem problem = two_ways_round();
  problem.task = problem.task.retimed([&] {
    const JointVector start = JointVector::Constant(1, problem.task.seam.start_time());
    const JointVector end = JointVector::Constant(1, problem.task.seam.end_time());
    const JointVector rate = JointVector::Constant(1, 1.0 / 3), zero = JointVector::Zero(1);
    return Trajectory{{start[0], 3 * end[0]}, {start, end}, {rate, rate}, {zero, zero}};
  }());
  problem.graph.spare_seeds = 0;
  const PlanResult result = plan(problem);
  EXPECT_EQ(result.status, Status::solved);
  EXPECT_EQ(result.seeds.size(), 1U);
  EXPECT_EQ(sides(result.trajectory, kSpeed / 3), kWeave);
}

TEST(TwoWaysRound, SpareSeedsCanBeCancelled) {
  Problem problem = two_ways_round();
  problem.refine.try_speeds = false;
  std::atomic<bool> cancel{false};
  PlanOptions options;
  options.monitor.cancel = &cancel;
  bool refined = false;
  // The search that comes after a refinement is the one for spare seeds.
  options.monitor.progress = [&](const std::string& stage, double) {
    if (stage == "refine") refined = true;
    if (stage == "search" && refined) cancel = true;
  };
  const PlanResult result = plan(problem, options);
  EXPECT_TRUE(cancel);
  EXPECT_EQ(result.status, Status::interrupted);
  ASSERT_EQ(result.seeds.size(), 1U);
  EXPECT_EQ(sides(result.seeds.front().path), kWeave);
  EXPECT_NE(result.seeds.front().refinement, "not run");
}

}  // namespace
}  // namespace wristwise
