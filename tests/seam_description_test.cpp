// Seams described in code, without names for messages and perhaps with values that make no seam.

#include "wristwise/seam_description.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "invalid_input.hpp"
#include "seam_samples.hpp"

namespace wristwise {
namespace {

using test::at;
using test::invalid_input;
using test::says;
using test::sliding_robot;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Segment straight(const Pose& from, const Pose& to) { return {LineSegment{from, to}}; }

SeamDescription two_lines() {
  SeamDescription seam;
  seam.segments = {straight(at(0, 0, 0), at(1, 0, 0)), straight(at(1, 0, 0), at(1, 1, 0))};
  seam.speed = 0.1;
  seam.spacing = 0.25;
  return seam;
}

std::string complaint(const SeamDescription& seam) {
  return invalid_input([&] { build_task(sliding_robot(), seam); });
}

TEST(SeamDescription, NeedsNoNames) {
  const Task task = build_task(sliding_robot(), two_lines());
  ASSERT_EQ(task.waypoints.size(), 9U);
  EXPECT_DOUBLE_EQ(task.waypoints[8].time, 20);
  EXPECT_TRUE(task.waypoints[6].frame.isApprox(at(1, 0.5, 0)));
}

TEST(SeamDescription, PosesByTimeOrBySpeed) {
  SeamDescription seam;
  seam.segments = {{PoseListSegment{{at(0, 0, 0), at(0.3, 0, 0), at(0.3, 0.3, 0)}, {1, 2, 5}}}};
  const Task task = build_task(sliding_robot(), seam);
  ASSERT_EQ(task.waypoints.size(), 3U);
  EXPECT_EQ(task.waypoints[0].time, 1);
  EXPECT_EQ(task.waypoints[2].time, 5);
  std::get<PoseListSegment>(seam.segments[0].shape).times.clear();
  seam.speed = 0.1;
  EXPECT_DOUBLE_EQ(build_task(sliding_robot(), seam).waypoints[2].time, 6);
}

TEST(SeamDescription, NamesSegmentsByNumber) {
  SeamDescription seam = two_lines();
  std::get<LineSegment>(seam.segments[1].shape).from = at(1, 0.1, 0);
  EXPECT_TRUE(says(complaint(seam), "segment 2: starts 0.1 m from the end"));
  seam.segments[1].where = "second pass";
  EXPECT_TRUE(says(complaint(seam), "second pass: starts"));
  seam.segments.clear();
  EXPECT_TRUE(says(complaint(seam), "seam: no segments"));
}

TEST(SeamDescription, RejectsWhatIsNotFinite) {
  SeamDescription seam = two_lines();
  std::get<LineSegment>(seam.segments[1].shape).to.translation().y() = kNan;
  EXPECT_TRUE(says(complaint(seam), "segment 2: a value that is not finite"));
  seam = two_lines();
  seam.segments[0].shape = ArcSegment{at(0, 0, 0), {1, 0, 0}, {0, 0, 1}, kNan};
  EXPECT_TRUE(says(complaint(seam), "segment 1: a value that is not finite"));
  seam = two_lines();
  seam.run_in = RunDescription{kNan};
  EXPECT_TRUE(says(complaint(seam), "run-in: nan m long"));
  seam = two_lines();
  seam.run_out = RunDescription{0.1, Eigen::Vector3d(0, kNan, 0)};
  EXPECT_TRUE(says(complaint(seam), "run-out: nan m long"));
  seam = two_lines();
  seam.speed = kNan;
  EXPECT_TRUE(says(complaint(seam), "seam: speed is nan"));
  seam = two_lines();
  seam.segments = {{PoseListSegment{{at(0, 0, 0), at(0.3, 0, 0)}, {1, kNan}}}};
  EXPECT_TRUE(says(complaint(seam), "segment 1, pose 2: a value that is not finite"));
}

TEST(SeamDescription, RejectsToleranceAndListsThatDoNotFit) {
  SeamDescription seam = two_lines();
  seam.segments[1].tolerance.lower[2] = 0.1;
  EXPECT_TRUE(says(complaint(seam), "segment 2"));
  seam.segments = {{PoseListSegment{{at(0, 0, 0), at(0.3, 0, 0)}, {1}}}};
  EXPECT_TRUE(says(complaint(seam), "segment 1: 1 times for 2 poses"));
  seam.segments = {{PoseListSegment{{at(0, 0, 0), at(0.3, 0, 0)}, {}, {"only one"}}}};
  EXPECT_TRUE(says(complaint(seam), "segment 1: 1 names for 2 poses"));
  seam.segments = {{PoseListSegment{}}};
  EXPECT_TRUE(says(complaint(seam), "segment 1: no poses"));
  seam.segments = {{JointListSegment{}}};
  EXPECT_TRUE(says(complaint(seam), "segment 1: no joint waypoints"));
  seam.segments = {{JointListSegment{
      {JointBox(JointVector(JointVector::Zero(3))), JointBox(JointVector(JointVector::Zero(2)))}}}};
  EXPECT_TRUE(says(complaint(seam), "segment 1, joint waypoint 2"));
}

}  // namespace
}  // namespace wristwise
