#include "refine/refinement.hpp"

#include <gtest/gtest.h>

#include <cstring>

#include "cancelled.hpp"
#include "refinement_example.hpp"
#include "three_point_optimum.hpp"
#include "wristwise/verification.hpp"

namespace wristwise {
namespace {

namespace gantry = test::gantry;
using gantry::posture;

using test::Example;
using test::kBall;
using test::kDuration;
using test::kObstacle;
using test::kRequired;
using test::kTau;
using test::obstacle_example;
using test::three_point_seed;
using test::three_point_task;
using test::ThreePointOptimum;

TEST(Refine, FindsTheOptimumThroughThreePoints) {
  Example example(gantry::parts(), three_point_task());
  example.cost.joint_weights = {1, 2, 0.5, 1};
  const Refined refined = example.run(three_point_seed(example.task));
  EXPECT_TRUE(refined.feasible);
  ThreePointOptimum optimum(4, kDuration, kTau);
  const double middle[] = {0.7, 0.3, -0.2, 0.1}, end[] = {1, -0.1, 0, 0};
  double objective = 0;
  for (int j = 0; j < 4; ++j) {
    optimum.pass_through(0, middle[j], end[j]);
    objective +=
        std::pow(example.cost.joint_weights[static_cast<std::size_t>(j)], 2) * optimum.objective();
    for (double t = 0; t <= kDuration; t += 0.37) {
      EXPECT_NEAR(refined.trajectory.evaluate(t)[j], optimum.value(t), 1e-4);
    }
  }
  EXPECT_NEAR(refined.statistics.objective, objective, 1e-4 * objective);
  EXPECT_LE(refined.statistics.max_violation, example.options.constraint_tolerance);
  EXPECT_TRUE(verify(example.task, example.clearance, refined.trajectory).passed);
}

/// The ranges at 4 s let x go straight from 0 to 1, hold y at its lower and z at its upper bound,
/// and leave the tilt one value.
TEST(Refine, FindsTheOptimumThroughTheRangesOfAJointWaypoint) {
  Example example(gantry::parts(), three_point_task());
  example.task.waypoints[40].joints =
      JointBox(posture(0.3, 0.2, -0.5, 0.1), posture(0.5, 0.4, -0.1, 0.1));
  example.task.waypoints.back().joints = posture(1, 0, 0, 0);
  const Refined refined = example.run(three_point_seed(example.task));
  EXPECT_TRUE(refined.feasible);
  ThreePointOptimum optimum(4, kDuration, kTau);
  const double middle[] = {0.4, 0.2, -0.1, 0.1}, end[] = {1, 0, 0, 0};
  double objective = 0;
  for (int j = 0; j < 4; ++j) {
    optimum.pass_through(0, middle[j], end[j]);
    objective += optimum.objective();
    for (double t = 0; t <= kDuration; t += 0.37) {
      EXPECT_NEAR(refined.trajectory.evaluate(t)[j], optimum.value(t), 1e-4);
    }
  }
  EXPECT_NEAR(refined.statistics.objective, objective, 1e-4 * objective);
  const JointVector q = refined.trajectory.evaluate(example.task.waypoints[40].time);
  EXPECT_GE(q[1], 0.2);
  EXPECT_LE(q[2], -0.1);
  EXPECT_TRUE(verify(example.task, example.clearance, refined.trajectory).passed);
}

TEST(Refine, TermsAddUpToTheObjective) {
  const Example example(gantry::parts(), three_point_task());
  const RefineStatistics statistics = example.run(three_point_seed(example.task)).statistics;
  EXPECT_TRUE(statistics.run);
  ASSERT_EQ(statistics.terms.size(), 7U);
  double sum = 0, initial = 0;
  for (const CostTerm& term : statistics.terms) {
    sum += term.final;
    initial += term.initial;
  }
  EXPECT_NEAR(sum, statistics.objective, 1e-9 * sum);
  EXPECT_LT(sum, 1e-2 * initial);
}

/// A corner of the seam at y = 0.3, cut as far as the box allows: y = 0.25 at 4 s, the rest free.
TEST(Refine, PressesTheTcpToTheEdgeOfItsBox) {
  Task task = gantry::task({{0, 0, 0}, {1, 0, 0}}, kDuration, 100, gantry::box(1.5, 1));
  task.waypoints.front().joints = posture(0, 0, 0);
  task.waypoints.back().joints = posture(1, 0, 0);
  Waypoint& corner = task.waypoints[40];
  corner.tolerance.lower[1] = 0.25;
  corner.tolerance.upper[1] = 0.35;
  // The stretch that ends there keeps the wide box of a joint waypoint instead: a move.
  std::vector<SeamPiece> pieces(3, task.seam.pieces().front());
  pieces[0].end_time = pieces[1].start_time = task.waypoints[39].time;
  pieces[1].end_time = pieces[2].start_time = corner.time;
  pieces[0].to = pieces[1].from = task.waypoints[39].frame;
  pieces[1].to = pieces[2].from = corner.frame;
  pieces[1].kind = SeamPiece::Kind::move;
  task.seam = Seam(pieces);
  JointPath seed = gantry::path_along(task);
  seed.positions[40][1] = 0.3;
  const Example example(gantry::parts(), task);
  const Refined refined = example.run(seed);
  EXPECT_TRUE(refined.feasible) << refined.statistics.termination;
  EXPECT_NEAR(refined.trajectory.positions()[40][1], 0.25, 1e-5);
  ThreePointOptimum optimum(4, kDuration, kTau);
  optimum.pass_through(0, 0.25, 0);
  // Along x the straight line at constant speed costs 1 / T.
  const double objective = optimum.objective() + 1 / kDuration;
  EXPECT_NEAR(refined.statistics.objective, objective, 1e-4 * objective);
  for (double t = 0; t <= kDuration; t += 0.37) {
    EXPECT_NEAR(refined.trajectory.evaluate(t)[1], optimum.value(t), 1e-4);
  }
}

TEST(Refine, KeepsTheSpeedLimitForAllTimes) {
  Task task = three_point_task();
  ThreePointOptimum optimum(4, kDuration, kTau);
  optimum.pass_through(0, 0.7, 1);
  double fastest = 0;
  for (double t = 0; t < kDuration; t += 0.01) {
    fastest = std::max(fastest, std::abs(optimum.value(t, 1)));
  }
  Robot::Parts parts = gantry::parts();
  const double limit = 0.7 / 4 + 0.5 * (fastest - 0.7 / 4);  // the middle must be reached
  ASSERT_LT(limit, 0.99 * fastest);
  parts.joints[0].max_velocity = limit;
  const Example example(parts, task);
  const Refined refined = example.run(three_point_seed(task));
  EXPECT_TRUE(refined.feasible) << refined.statistics.termination;
  const Verification verification = verify(task, example.clearance, refined.trajectory);
  EXPECT_TRUE(verification.passed) << ::testing::PrintToString(verification.failures);
  EXPECT_LE(verification.velocity_ratio, 1);
  EXPECT_GT(verification.velocity_ratio, 0.99);
  const Refined unlimited = Example(gantry::parts(), task).run(three_point_seed(task));
  EXPECT_GT(refined.statistics.objective, unlimited.statistics.objective);
}

TEST(Refine, KeepsAccelerationAndJerkLimits) {
  const Task task = three_point_task();
  const Refined unlimited = Example(gantry::parts(), task).run(three_point_seed(task));
  const auto peak = [](const Trajectory& trajectory, int derivative) {
    double largest = 0;
    for (double t = 0; t < kDuration; t += 1e-3) {
      largest = std::max(largest, trajectory.evaluate(t, derivative).cwiseAbs().maxCoeff());
    }
    return largest;
  };
  for (const int derivative : {2, 3}) {
    Robot::Parts parts = gantry::parts();
    const double limit = 0.85 * peak(unlimited.trajectory, derivative);
    for (Joint& joint : parts.joints) {
      (derivative == 2 ? joint.max_acceleration : joint.max_jerk) = limit;
    }
    const Example example(parts, task);
    const Refined refined = example.run(three_point_seed(task));
    EXPECT_TRUE(refined.feasible) << derivative << " " << refined.statistics.termination;
    EXPECT_LE(peak(refined.trajectory, derivative), limit);
    EXPECT_GT(peak(refined.trajectory, derivative), 0.95 * limit);
    EXPECT_GT(refined.statistics.objective, unlimited.statistics.objective);
  }
}

TEST(Refine, GoesRoundAnObstacleAtTheRequiredClearance) {
  ToleranceBox box = gantry::box(0, 0.1);
  box.lower[1] = -0.5;
  box.upper[1] = 0.5;
  Example example = obstacle_example(box, 40);
  for (Waypoint* end : {&example.task.waypoints.front(), &example.task.waypoints.back()}) {
    end->tolerance = gantry::box(0, 0.1);
  }
  const Refined refined = example.run();
  EXPECT_TRUE(refined.feasible) << refined.statistics.termination;
  const Verification verification = verify(example.task, example.clearance, refined.trajectory);
  EXPECT_TRUE(verification.passed) << ::testing::PrintToString(verification.failures);
  double least = INFINITY;
  for (double t = 0; t <= kDuration; t += 1e-3) {
    const Eigen::Vector3d centre = refined.trajectory.evaluate(t).head<3>();
    least = std::min(least, (centre - Eigen::Vector3d(0.5, -0.01, 0)).norm() - kBall - kObstacle);
  }
  EXPECT_GE(least, kRequired);
  EXPECT_LT(least, kRequired + 2 * example.options.clearance_epsilon);
}

TEST(Refine, SaysThatABoxInsideAnObstacleIsInfeasible) {
  Example example = obstacle_example(gantry::box(0.001, 0.1), 10);
  const Refined refined = example.run();
  EXPECT_FALSE(refined.feasible);
  EXPECT_FALSE(refined.trajectory.empty());
  EXPECT_GT(refined.statistics.max_violation, 0.01);
  EXPECT_FALSE(verify(example.task, example.clearance, refined.trajectory).passed);
}

TEST(Refine, GivesTheSameBytesEveryTime) {
  ToleranceBox box = gantry::box(0, 0.1);
  box.lower[1] = -0.5;
  box.upper[1] = 0.5;
  const Example example = obstacle_example(box, 20);
  const Refined one = example.run(), other = example.run();
  ASSERT_EQ(one.trajectory.times().size(), other.trajectory.times().size());
  for (std::size_t i = 0; i < one.trajectory.times().size(); ++i) {
    for (const auto member :
         {&Trajectory::positions, &Trajectory::velocities, &Trajectory::accelerations}) {
      EXPECT_EQ(std::memcmp((one.trajectory.*member)()[i].data(),
                            (other.trajectory.*member)()[i].data(), 4 * sizeof(double)),
                0);
    }
  }
}

TEST(Refine, StopsWhenCancelled) {
  std::atomic<bool> cancel{true};
  Example example(gantry::parts(), three_point_task());
  example.monitor.cancel = &cancel;
  EXPECT_THROW(example.run(three_point_seed(example.task)), Cancelled);
  cancel = false;
  int reports = 0;
  example.monitor.progress = [&](const std::string& stage, double fraction) {
    EXPECT_EQ(stage, "refine");
    EXPECT_GE(fraction, 0);
    EXPECT_LE(fraction, 1);
    if (++reports == 2) cancel = true;
  };
  EXPECT_THROW(example.run(three_point_seed(example.task)), Cancelled);
  EXPECT_EQ(reports, 2);
}

}  // namespace
}  // namespace wristwise
