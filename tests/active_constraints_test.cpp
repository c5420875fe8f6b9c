#include "refine/active_constraints.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "gantry.hpp"
#include "refine/refinement.hpp"

// The forecast from the multipliers against really widening the bound and refining again.

namespace wristwise {
namespace {

namespace gantry = test::gantry;
using gantry::posture;

struct Example {
  Robot::Parts parts = gantry::parts();
  Task task;
  std::vector<SceneObject> objects;
  double clearance = 0.02;

  RefineStatistics run() const {
    const auto robot = gantry::robot(parts);
    RefineOptions options;
    options.smoothing_time = 2;
    const CostOptions cost;
    const Monitor monitor;
    const Refined refined =
        refine({*robot, task, gantry::clearance(robot, objects, clearance), cost, options, monitor},
               gantry::path_along(task));
    EXPECT_TRUE(refined.feasible) << refined.statistics.termination;
    return refined.statistics;
  }
};

/// The stretches of one constraint that lie within [from, to] (s), as one.
ActiveConstraint find(const RefineStatistics& statistics, const std::string& name, double from = 0,
                      double to = 10) {
  ActiveConstraint found;
  for (const ActiveConstraint& constraint : statistics.active) {
    if (constraint.name != name || constraint.from < from || constraint.to > to) continue;
    const double gain = found.relative_gain;
    if (gain == 0) found = constraint;
    found.from = std::min(found.from, constraint.from);
    found.to = std::max(found.to, constraint.to);
    found.relative_gain = gain + constraint.relative_gain;
  }
  EXPECT_GT(found.relative_gain, 0) << "no " << name << " among the active constraints";
  return found;
}

/// The share of the objective that is saved per unit, by trying.
double measured_gain(const Example& example, double step,
                     const std::function<void(Example&, double)>& widen) {
  Example wider = example, narrower = example;
  widen(wider, step);
  widen(narrower, -step);
  const double objective = example.run().objective;
  return (narrower.run().objective - wider.run().objective) / (2 * step * objective);
}

/// From y = 0 up to at least y = 0.25 and back, else free.
Example over_a_hurdle() {
  Example example;
  example.task = gantry::task({{0, 0, 0}, {1, 0, 0}}, 10, 40, gantry::box(1.5, 1));
  for (Waypoint* end : {&example.task.waypoints.front(), &example.task.waypoints.back()})
    end->joints = end == &example.task.waypoints.front() ? posture(0, 0, 0) : posture(1, 0, 0);
  Waypoint& hurdle = example.task.waypoints[20];
  hurdle.joints = JointBox(posture(-1, 0.25, -1, -1), posture(2, 1.5, 1, 1));
  return example;
}

TEST(ActiveConstraints, ARangeOfAJoint) {
  const Example example = over_a_hurdle();
  const ActiveConstraint hurdle = find(example.run(), "y", 1, 9);
  EXPECT_NEAR(hurdle.from, 5, 1e-9);
  EXPECT_NEAR(hurdle.to, 5, 1e-9);
  EXPECT_EQ(hurdle.unit, ActiveConstraint::Unit::metre);
  const double measured = measured_gain(example, 0.01, [](Example& changed, double by) {
    changed.task.waypoints[20].joints->lower[1] -= by;
  });
  EXPECT_NEAR(hurdle.relative_gain, measured, 0.03 * measured);
  EXPECT_NE(hurdle.sentence.find("y is at its lower limit"), std::string::npos) << hurdle.sentence;
}

TEST(ActiveConstraints, AJointNamedLikeAPairOfBodiesIsNone) {
  Example example = over_a_hurdle();
  example.parts.joints[1].name = "y - slide";
  const ActiveConstraint hurdle = find(example.run(), "y - slide", 1, 9);
  EXPECT_NE(hurdle.sentence.find("y - slide is at its lower limit"), std::string::npos)
      << hurdle.sentence;
}

TEST(ActiveConstraints, AClearance) {
  Example example;
  ToleranceBox box = gantry::box(0, 0.1);
  box.lower[1] = -0.5;
  box.upper[1] = 0.5;
  example.task = gantry::task({{0, 0, 0}, {1, 0, 0}}, 10, 40, box);
  example.task.waypoints.front().joints = posture(0, 0, 0);
  example.task.waypoints.back().joints = posture(1, 0, 0);
  example.objects = {gantry::obstacle(Sphere{0.1}, 0.5, -0.02, 0)};
  const ActiveConstraint pair = find(example.run(), "ball - obstacle");
  const double measured =
      measured_gain(example, 1e-3, [](Example& changed, double by) { changed.clearance -= by; });
  EXPECT_NEAR(pair.relative_gain, measured, 0.02 * measured);
  EXPECT_GT(pair.from, 3);
  EXPECT_LT(pair.to, 7);
}

TEST(ActiveConstraints, ASpeedLimit) {
  Example example = over_a_hurdle();
  example.parts.joints[1].max_velocity = 0.07;
  const ActiveConstraint limit = find(example.run(), "y velocity");
  EXPECT_EQ(limit.unit, ActiveConstraint::Unit::share);
  const double measured = measured_gain(example, 0.01, [](Example& changed, double by) {
    changed.parts.joints[1].max_velocity *= 1 + by;
  });
  EXPECT_NEAR(limit.relative_gain, measured, 0.03 * measured);
}

/// A seam that swings in z: without tolerance it must be followed.
TEST(ActiveConstraints, AWidthOfZero) {
  Example example;
  example.task = gantry::task({{0, 0, 0}, {1, 0, 0}}, 10, 40, gantry::box(0.001, 0.1));
  for (Waypoint& waypoint : example.task.waypoints) {
    waypoint.frame.translation().z() = 0.05 * std::sin(0.2 * M_PI * waypoint.time);
    waypoint.tolerance.lower[2] = waypoint.tolerance.upper[2] = 0;
  }
  std::vector<SeamPiece> pieces;
  for (std::size_t i = 0; i + 1 < example.task.waypoints.size(); ++i) {
    SeamPiece piece;
    piece.from = example.task.waypoints[i].frame;
    piece.to = example.task.waypoints[i + 1].frame;
    piece.start_time = example.task.waypoints[i].time;
    piece.end_time = example.task.waypoints[i + 1].time;
    pieces.push_back(piece);
  }
  example.task.seam = Seam(pieces);
  example.task.between_position = 0.01;  // the curve is rounder than the lines
  const RefineStatistics tight = example.run();
  const ActiveConstraint z = find(tight, "z");
  EXPECT_EQ(z.from, 0);
  EXPECT_EQ(z.to, 10);
  constexpr double kStep = 1e-5;
  for (Waypoint& waypoint : example.task.waypoints) {
    waypoint.tolerance.lower[2] = -kStep;
    waypoint.tolerance.upper[2] = kStep;
  }
  const double measured = (tight.objective - example.run().objective) / (kStep * tight.objective);
  EXPECT_LE(measured, 1.02 * z.relative_gain);  // convex: the forecast is the most there can be
  EXPECT_GE(measured, 0.4 * z.relative_gain);   // over a short range
}

TEST(ActiveConstraints, NothingIsListedWhereNothingPresses) {
  Example example;
  example.task = gantry::task({{0, 0, 0}, {1, 0, 0}}, 10, 40, gantry::box(1.5, 1));
  for (const ActiveConstraint& constraint : example.run().active)
    ADD_FAILURE() << constraint.sentence;
}

}  // namespace
}  // namespace wristwise
