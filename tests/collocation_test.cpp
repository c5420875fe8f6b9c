#include "refine/collocation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "gantry.hpp"

namespace wristwise {
namespace {

namespace gantry = test::gantry;

Task fine_task(int waypoints) {
  return gantry::task({{0, 0, 0}, {1, 0, 0}}, 10, waypoints - 1, gantry::box(0.01, 0.1));
}

/// q = (t / 10, 0, 0, 0): the seam itself.
Spline along_the_seam(std::vector<double> breakpoints) {
  return fit_spline({{0, 10}, {gantry::posture(0, 0, 0), gantry::posture(1, 0, 0)}},
                    std::move(breakpoints));
}

TEST(Collocation, TakesAFewWaypointsOfEachSpan) {
  const Task task = fine_task(1001);
  const SplineBasis basis({0, 2, 4, 6, 8, 10});
  const auto points = Collocation(task).choose(basis, 3, 1, {});
  EXPECT_GE(points.size(), 15U);
  EXPECT_LE(points.size(), 17U);
  EXPECT_EQ(points.front().time, 0);
  EXPECT_EQ(points.back().time, 10);
  double weight = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    weight += points[i].weight;
    if (i == 0) continue;
    EXPECT_GT(points[i].time, points[i - 1].time);
    EXPECT_LT(points[i].time - points[i - 1].time, 1.4);
  }
  EXPECT_NEAR(weight, 10, 0.01);  // they stand for the whole motion
}

TEST(Collocation, TakesAllWhereThereAreFewAndEveryJointWaypoint) {
  EXPECT_EQ(Collocation(fine_task(8)).choose(SplineBasis({0, 5, 10}), 4, 1, {}).size(), 8U);
  Task task = fine_task(1001);
  task.waypoints[123].joints = gantry::posture(0, 0, 0);
  const auto points = Collocation(task).choose(SplineBasis({0, 10}), 2, 1, {});
  EXPECT_TRUE(std::any_of(points.begin(), points.end(), [&](const PointConstraint& point) {
    return point.time == task.waypoints[123].time && point.rows.size() == 4;
  }));
}

TEST(Collocation, KnowsWhetherAllWereTaken) {
  const Task task = fine_task(21);
  Collocation collocation(task);
  collocation.choose(SplineBasis({0, 5, 10}), 20, 1, {});
  EXPECT_TRUE(collocation.is_complete());
  collocation.choose(SplineBasis({0, 5, 10}), 9, 1, {});
  EXPECT_FALSE(collocation.is_complete());
}

TEST(Collocation, LeavesOutWhatIsLessViolatedThanAChosenWaypoint) {
  Task task = fine_task(1001);
  const Spline spline = along_the_seam({0, 2, 4, 6, 8, 10});
  const auto robot = gantry::robot();
  Collocation collocation(task);
  const auto chosen = collocation.choose(spline.basis, 3, 1, {});
  const auto in_span = std::find_if(chosen.begin(), chosen.end(),
                                    [](const PointConstraint& point) { return point.time > 4.1; });
  ASSERT_LT(in_span->time, 5.9);
  const auto at = static_cast<std::size_t>(std::lround(in_span->time * 100));
  ASSERT_EQ(task.waypoints[at].time, in_span->time);
  task.waypoints[at].frame.translation().y() = 0.02;
  task.waypoints[at + 3].frame.translation().y() = 0.015;
  EXPECT_TRUE(collocation.violated(*robot, spline, 1e-6, 1).empty());
  task.waypoints[at + 3].frame.translation().y() = 0.025;
  const auto found = collocation.violated(*robot, spline, 1e-6, 1);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].time, task.waypoints[at + 3].time);
}

TEST(Collocation, MultipliersAreDensities) {
  const Task task = fine_task(1001);
  const SplineBasis basis({0, 2, 4, 6, 8, 10});
  auto coarse = Collocation(task).choose(basis, 1, 1, {});
  double sum = 0;
  for (PointConstraint& point : coarse) {
    point.rows[1].bounds.multiplier = 3 * point.weight;
    sum += point.rows[1].bounds.multiplier;
  }
  const auto fine = Collocation(task).choose(basis, 5, 1, coarse);
  double fine_sum = 0;
  for (const PointConstraint& point : fine) {
    EXPECT_NEAR(point.rows[1].bounds.multiplier, 3 * point.weight, 1e-9);
    EXPECT_EQ(point.rows[0].bounds.multiplier, 0);
    fine_sum += point.rows[1].bounds.multiplier;
  }
  EXPECT_NEAR(fine_sum, sum, 1e-6 * sum);
}

TEST(Collocation, FindsTheWaypointThatIsLeftOutAndDoesNotHold) {
  Task task = fine_task(1001);
  const Spline spline = along_the_seam({0, 2, 4, 6, 8, 10});
  const auto robot = gantry::robot();
  Collocation collocation(task);
  collocation.choose(spline.basis, 3, 1, {});
  EXPECT_TRUE(collocation.violated(*robot, spline, 1e-6, 1).empty());
  // Two waypoints of one span and one of another are moved out of reach of the curve.
  task.waypoints[431].frame.translation().y() = 0.011;
  task.waypoints[437].frame.translation().y() = 0.013;
  task.waypoints[655].frame.translation().z() = -0.02;
  const auto found = collocation.violated(*robot, spline, 1e-6, 1);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].time, task.waypoints[437].time);
  EXPECT_EQ(found[1].time, task.waypoints[655].time);
  EXPECT_TRUE(collocation.violated(*robot, spline, 0.02, 1).empty());
}

}  // namespace
}  // namespace wristwise
