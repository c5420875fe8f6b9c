#include "timing/retiming.hpp"

#include <gtest/gtest.h>

#include "timing/motion_rates.hpp"

namespace wristwise {
namespace {

/// 1 m along x from 2 s to 6 s, five waypoints.
Task straight_task() {
  SeamPiece line;
  line.to.translation() = Eigen::Vector3d::UnitX();
  line.start_time = 2;
  line.end_time = 6;
  Task task;
  task.seam = Seam({line});
  for (int i = 0; i < 5; ++i) {
    Waypoint waypoint;
    waypoint.time = 2 + i;
    waypoint.frame = task.seam.frame_at(waypoint.time);
    task.waypoints.push_back(waypoint);
  }
  return task;
}

JointVector one(double value) { return JointVector::Constant(1, value); }

/// From 2 s, half as fast: at the end of the seam at 10 s.
Trajectory half_speed() {
  return {{2, 10}, {one(2), one(6)}, {one(0.5), one(0.5)}, {one(0), one(0)}};
}

void expect_same_times(const Task& a, const Task& b) {
  ASSERT_EQ(a.waypoints.size(), b.waypoints.size());
  for (std::size_t i = 0; i < a.waypoints.size(); ++i) {
    EXPECT_NEAR(a.waypoints[i].time, b.waypoints[i].time, 1e-9);
    EXPECT_TRUE(a.seam.frame_at(a.waypoints[i].time).isApprox(a.waypoints[i].frame, 1e-9));
  }
}

TEST(Retiming, TheTimeOfATaskWithoutALawIsItsOwn) {
  const Trajectory law = seam_time_of(straight_task());
  for (double t = 2; t <= 6; t += 0.5) EXPECT_NEAR(law.evaluate(t)[0], t, 1e-12);
}

TEST(Retiming, AStretchedTaskIsPassedLaterAtTheSamePlaces) {
  const Task task = straight_task(), slow = stretched(task, 3);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_NEAR(slow.waypoints[i].time, 2 + 3.0 * static_cast<double>(i), 1e-9);
    EXPECT_TRUE(slow.seam.frame_at(slow.waypoints[i].time).isApprox(task.waypoints[i].frame, 1e-9));
  }
  EXPECT_NEAR(slow.seam.end_time(), 14, 1e-9);
}

TEST(Retiming, LawsFollowOneAnother) {
  const Task task = straight_task();
  expect_same_times(run_along(task, half_speed()), stretched(task, 2));
  const Task slow = stretched(task, 1.5);  // 2 s to 8 s
  const Trajectory law = {{2, 14}, {one(2), one(8)}, {one(0.5), one(0.5)}, {one(0), one(0)}};
  expect_same_times(run_along(slow, law), stretched(task, 3));
  expect_same_times(stretched(stretched(task, 2), 1.5), stretched(task, 3));
}

TEST(Retiming, APathMovesToTheTimesOfTheWaypoints) {
  const Task slow = stretched(straight_task(), 2);
  JointPath path;
  for (int i = 0; i < 5; ++i) {
    path.times.push_back(i);
    path.positions.push_back(one(i));
  }
  const JointPath moved = at_waypoints_of(slow, path);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(moved.times[i], slow.waypoints[i].time);
    EXPECT_EQ(moved.positions[i], path.positions[i]);
  }
}

}  // namespace
}  // namespace wristwise
