// Stage 2 from rest and to rest.

#include <gtest/gtest.h>

#include <random>

#include "refinement_example.hpp"
#include "three_point_optimum.hpp"
#include "wristwise/verification.hpp"

namespace wristwise {
namespace {

namespace gantry = test::gantry;
using test::Example;
using test::kDuration;
using test::kTau;
using test::ThreePointOptimum;

struct Rest {
  bool at_start, at_end;
};

void PrintTo(const Rest& rest, std::ostream* out) {
  *out << (rest.at_start ? "rest" : "free") << " to " << (rest.at_end ? "rest" : "free");
}

void rest(Task& task, const Rest& of) {
  task.rest_at_start = of.at_start;
  task.rest_at_end = of.at_end;
}

/// Velocity and acceleration at the ends are zero, but for the rounding of sums of equal control
/// points, where they have to be, and not elsewhere.
void expect_rest(const Trajectory& trajectory, const Rest& of) {
  for (const auto& derivative : {trajectory.velocities(), trajectory.accelerations()}) {
    EXPECT_EQ(derivative.front().isZero(1e-12), of.at_start) << derivative.front().transpose();
    EXPECT_EQ(derivative.back().isZero(1e-12), of.at_end) << derivative.back().transpose();
  }
}

class RefineFromRest : public testing::TestWithParam<Rest> {};

TEST_P(RefineFromRest, FindsTheOptimumThroughThreePoints) {
  Example example(gantry::parts(), test::three_point_task());
  rest(example.task, GetParam());
  const Refined refined = example.run(test::three_point_seed(example.task));
  EXPECT_TRUE(refined.feasible) << refined.statistics.termination;
  expect_rest(refined.trajectory, GetParam());
  ThreePointOptimum optimum(4, kDuration, kTau, {GetParam().at_start, GetParam().at_end});
  const double middle[] = {0.7, 0.3, -0.2, 0.1}, end[] = {1, -0.1, 0, 0};
  double objective = 0;
  for (int j = 0; j < 4; ++j) {
    optimum.pass_through(0, middle[j], end[j]);
    objective += optimum.objective();
    for (double t = 0; t <= kDuration; t += 0.37)
      EXPECT_NEAR(refined.trajectory.evaluate(t)[j], optimum.value(t), 1e-4) << t;
  }
  EXPECT_NEAR(refined.statistics.objective, objective, 1e-4 * objective);
  const Verification verification = verify(example.task, example.clearance, refined.trajectory);
  EXPECT_TRUE(verification.passed) << testing::PrintToString(verification.failures);
}

/// Stops the torch and makes it cost more; what was found without rest does not pass.
TEST_P(RefineFromRest, CostsMoreThanWithoutAndIsAskedFor) {
  Example example(gantry::parts(), test::three_point_task());
  const JointPath seed = test::three_point_seed(example.task);
  const Refined free = example.run(seed);
  rest(example.task, GetParam());
  const Refined refined = example.run(seed);
  const bool any = GetParam().at_start || GetParam().at_end;
  EXPECT_EQ(refined.statistics.objective > 1.01 * free.statistics.objective, any);
  EXPECT_EQ(verify(example.task, example.clearance, free.trajectory).passed, !any);
}

/// Limits of joints and rates, where the end control points count as one.
TEST_P(RefineFromRest, KeepsTheLimits) {
  Robot::Parts parts = gantry::parts();
  for (Joint& joint : parts.joints) {
    joint.max_velocity = 0.35;
    joint.max_acceleration = 0.35;
    joint.max_jerk = 0.8;
  }
  Example example(parts, test::three_point_task());
  rest(example.task, GetParam());
  const Refined refined = example.run(test::three_point_seed(example.task));
  EXPECT_TRUE(refined.feasible) << refined.statistics.termination;
  expect_rest(refined.trajectory, GetParam());
  const Verification verification = verify(example.task, example.clearance, refined.trajectory);
  EXPECT_TRUE(verification.passed) << testing::PrintToString(verification.failures);
  for (double t = 0; t <= kDuration; t += 1e-2) {
    EXPECT_LE(refined.trajectory.evaluate(t, 1).cwiseAbs().maxCoeff(), 0.35);
    EXPECT_LE(refined.trajectory.evaluate(t, 2).cwiseAbs().maxCoeff(), 0.35);
  }
}

/// Random start, middle and end postures, from a noisy seed.
TEST_P(RefineFromRest, HoldsForRandomPostures) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(-0.4, 0.4);
  for (int k = 0; k < 5; ++k) {
    Example example(gantry::parts(), test::three_point_task());
    rest(example.task, GetParam());
    for (const std::size_t i : {std::size_t{0}, std::size_t{40}, std::size_t{100}}) {
      Waypoint& waypoint = example.task.waypoints[i];
      waypoint.joints = gantry::posture(waypoint.frame.translation().x() + any(random), any(random),
                                        any(random), any(random));
    }
    JointPath seed = test::three_point_seed(example.task);
    for (std::size_t i = 0; i < seed.size(); ++i) {
      if (example.task.waypoints[i].joints) continue;
      for (int j = 0; j < 4; ++j) seed.positions[i][j] += 0.1 * any(random);
    }
    const Refined refined = example.run(seed);
    EXPECT_TRUE(refined.feasible) << refined.statistics.termination;
    expect_rest(refined.trajectory, GetParam());
    EXPECT_TRUE(verify(example.task, example.clearance, refined.trajectory).passed);
  }
}

INSTANTIATE_TEST_SUITE_P(Ends, RefineFromRest,
                         testing::Values(Rest{false, false}, Rest{true, false}, Rest{false, true},
                                         Rest{true, true}));

/// The same forwards and backwards: x(T - t) = 1 - x(t), the rest mirrored.
TEST(RefineRestToRest, IsSymmetricWhereTheProblemIs) {
  ToleranceBox box = gantry::box(0.01, 0.1);
  box.lower.head<2>() << -0.3, -0.5;  // at rest the torch lags behind the seam
  box.upper.head<2>() << 0.3, 0.5;
  Example example = test::obstacle_example(box, 40);
  for (Waypoint* end : {&example.task.waypoints.front(), &example.task.waypoints.back()})
    end->joints = gantry::posture(end->frame.translation().x(), 0, 0);
  rest(example.task, {true, true});
  const Refined refined = example.run();
  ASSERT_TRUE(refined.feasible) << refined.statistics.termination;
  expect_rest(refined.trajectory, {true, true});
  EXPECT_TRUE(verify(example.task, example.clearance, refined.trajectory).passed);
  for (double t = 0; t <= kDuration; t += 0.1) {
    const JointVector q = refined.trajectory.evaluate(t);
    const JointVector mirrored = refined.trajectory.evaluate(kDuration - t);
    EXPECT_NEAR(mirrored[0], 1 - q[0], 2e-3) << t;
    for (int j = 1; j < 4; ++j) EXPECT_NEAR(mirrored[j], q[j], 2e-3) << t;
  }
}

/// A weld at 0.1 m/s from its first moment on: from rest, at 0.5 m/s^2, the torch is 10 mm late.
TEST(RefineRestToRest, IsInfeasibleWhereTheTorchCantCatchUp) {
  Robot::Parts parts = gantry::parts();
  parts.joints[0].max_acceleration = 0.5;
  for (const bool possible : {true, false}) {
    Example example(parts, gantry::task({{0, 0, 0}, {1, 0, 0}}, kDuration, 40,
                                        gantry::box(possible ? 0.03 : 5e-3, 0.1)));
    rest(example.task, {true, false});
    const Refined refined = example.run();
    EXPECT_EQ(refined.feasible, possible) << refined.statistics.termination;
    EXPECT_EQ(verify(example.task, example.clearance, refined.trajectory).passed, possible);
  }
}

}  // namespace
}  // namespace wristwise
