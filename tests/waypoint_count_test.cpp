// The objective of stage 2 belongs to the motion: it does not depend on how many waypoints the seam
// is cut into.

#include <gtest/gtest.h>

#include "refinement_example.hpp"
#include "wristwise/verification.hpp"

namespace wristwise {
namespace {

namespace gantry = test::gantry;
using test::Example;
using test::kDuration;

double objective(Example& example) {
  const Refined refined = example.run();
  EXPECT_TRUE(refined.feasible) << refined.statistics.termination;
  EXPECT_TRUE(verify(example.task, example.clearance, refined.trajectory).passed);
  return refined.statistics.objective;
}

/// The ends are held, between them the box is wide.
void hold_ends(Task& task) {
  for (Waypoint* end : {&task.waypoints.front(), &task.waypoints.back()}) {
    const Eigen::Vector3d p = end->frame.translation();
    end->joints = gantry::posture(p.x(), p.y(), p.z());
  }
}

TEST(WaypointCount, LeavesTheObjectiveOfACorner) {
  std::vector<double> objectives;
  for (const int intervals : {25, 50, 200}) {
    Example example(gantry::parts(), gantry::task({{0, 0, 0}, {0.5, 0.2, 0}, {1, 0, 0}}, kDuration,
                                                  intervals, gantry::box(0.03, 0.1)));
    example.task.between_position = 1e-6;
    objectives.push_back(objective(example));
  }
  for (const double other : objectives) EXPECT_NEAR(other, objectives[2], 1e-3 * objectives[2]);
}

TEST(WaypointCount, LeavesTheObjectiveOfAWayRoundAnObstacle) {
  ToleranceBox box = gantry::box(0, 0.1);
  box.lower[1] = -0.5;
  box.upper[1] = 0.5;
  std::vector<double> objectives;
  for (const int intervals : {50, 100, 400}) {
    Example example = test::obstacle_example(box, intervals);
    hold_ends(example.task);
    objectives.push_back(objective(example));
  }
  for (const double other : objectives) EXPECT_NEAR(other, objectives[2], 1e-3 * objectives[2]);
}

}  // namespace
}  // namespace wristwise
