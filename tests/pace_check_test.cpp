#include <gtest/gtest.h>

#include <algorithm>

#include "invalid_input.hpp"
#include "seam_samples.hpp"
#include "temporary_folder.hpp"
#include "verify/row_waypoints.hpp"
#include "wristwise/plan.hpp"

namespace wristwise {
namespace {

using test::at;
using test::describe;
using test::file_text;
using test::line;
using test::says;
using test::TemporaryFolder;

const std::vector<std::string> kJoints = {"x", "y", "z"};

/// An L at 10 mm/s with a stop at its corner, a run-in and a run-out.
SeamDescription description() {
  SeamDescription seam =
      describe({line(at(0, 0, 0), at(0.1, 0, 0)), line(at(0.1, 0, 0), at(0.1, 0.05, 0))});
  seam.corners.kind = CornerOptions::Kind::stop;
  seam.run_in.emplace();
  seam.run_in->length = 0.01;
  seam.run_out.emplace();
  seam.run_out->away = Eigen::Vector3d(0, 0, -0.02);
  return seam;
}

Problem problem_of(const SeamDescription& seam) {
  Problem problem;
  problem.robot = std::make_shared<const Robot>(test::sliding_robot());
  problem.scene.scope = CollisionScope::off;
  problem.task = build_task(*problem.robot, seam);
  return problem;
}

std::vector<double> waypoint_times(const Task& task) {
  std::vector<double> times;
  for (const Waypoint& waypoint : task.waypoints) times.push_back(waypoint.time);
  return times;
}

/// Follows the seam, by numeric derivatives.
Trajectory along(const Task& task, const std::vector<double>& times) {
  std::vector<JointVector> positions, velocities, accelerations;
  const double h = 1e-4;
  for (const double time : times) {
    const double t = std::clamp(time, times.front() + h, times.back() - h);
    const JointVector left = task.seam.frame_at(t - h).translation();
    const JointVector middle = task.seam.frame_at(t).translation();
    const JointVector right = task.seam.frame_at(t + h).translation();
    positions.push_back(task.seam.frame_at(time).translation());
    velocities.push_back((right - left) / (2 * h));
    accelerations.push_back((right - 2 * middle + left) / (h * h));
  }
  for (auto* derivative : {&velocities, &accelerations}) {
    if (task.rest_at_start) derivative->front().setZero();
    if (task.rest_at_end) derivative->back().setZero();
  }
  return {times, positions, velocities, accelerations};
}

/// As it would come back from a file.
TrajectoryFile file_of(const Task& task) {
  TrajectoryFile file;
  file.trajectory = along(task, waypoint_times(task));
  file.path = file.trajectory->waypoints();
  if (task.seam.is_retimed()) file.seam_time = task.seam.seam_time();
  return file;
}

struct LawKnot {
  double time, nominal, rate;
};

Trajectory law(const std::vector<LawKnot>& knots) {
  std::vector<double> times;
  std::vector<JointVector> nominal, rates;
  for (const LawKnot& knot : knots) {
    times.push_back(knot.time);
    nominal.push_back(JointVector::Constant(1, knot.nominal));
    rates.push_back(JointVector::Constant(1, knot.rate));
  }
  return {times, nominal, rates, std::vector<JointVector>(knots.size(), JointVector::Zero(1))};
}

/// A straight seam of 10 s that is run by the given law.
Verification check_straight(const Trajectory& seam_time, SpeedPolicy policy = SpeedPolicy::hold) {
  Problem problem = problem_of(describe({line(at(0, 0, 0), at(0.1, 0, 0))}));
  problem.task.speed_policy = policy;
  TrajectoryFile file;
  file.seam_time = seam_time;
  Task run = problem.task;
  try {
    run = problem.task.retimed(seam_time);
  } catch (const InvalidInput&) {
    // As the law can't be followed any motion will do.
  }
  const Trajectory motion = along(run, waypoint_times(run));
  file.path = motion.waypoints();
  return check(problem, file);
}

void expect_failure(const Verification& result, const std::vector<std::string>& parts) {
  EXPECT_FALSE(result.passed);
  ASSERT_EQ(result.failures.size(), 1U) << testing::PrintToString(result.failures);
  for (const std::string& part : parts)
    EXPECT_TRUE(says(result.failures[0], part)) << result.failures[0] << " lacks " << part;
}

TEST(SeamColumns, OnlyWhereTheTaskHasThem) {
  SeamDescription seam = describe({line(at(0, 0, 0), at(0.1, 0, 0))});
  EXPECT_TRUE(SeamColumns(problem_of(seam).task).names().empty());
  seam.run_in.emplace();
  seam.run_in->length = 0.01;
  EXPECT_EQ(SeamColumns(problem_of(seam).task).names(), std::vector<std::string>{"welding"});
  EXPECT_EQ(SeamColumns(problem_of(description()).task).names().size(), 4U);
}

TEST(SeamColumns, ComeBackFromTheFile) {
  const TemporaryFolder folder;
  const Task task = problem_of(description()).task;
  const Trajectory motion = along(task, waypoint_times(task));
  const auto curve = folder.path() / "curve.csv", points = folder.path() / "points.csv";
  write_trajectory(curve, kJoints, motion, SeamColumns(task));
  write_path(points, kJoints, motion.waypoints(), SeamColumns(task));
  EXPECT_TRUE(says(file_text(curve),
                   "z_acceleration,welding,seam_time,seam_time_velocity,seam_time_acceleration\n"));
  EXPECT_TRUE(says(file_text(points), "time,x,y,z,welding,seam_time,"));
  for (const auto& path : {curve, points}) {
    const TrajectoryFile file = read_trajectory(path, kJoints);
    EXPECT_EQ(file.trajectory.has_value(), path == curve);
    ASSERT_TRUE(file.seam_time);
    for (const double t : test::steps(motion.times().front(), motion.times().back(), 0.01))
      EXPECT_NEAR(file.seam_time->evaluate(t)[0], task.seam.nominal_time(t), 1e-12) << t;
  }
}

TEST(SeamColumns, WeldingIsBetweenTheEndsOfTheWeld) {
  const Task task = problem_of(description()).task;
  const SeamColumns columns(task);
  for (const Waypoint& waypoint : task.waypoints)
    EXPECT_EQ(columns.values(waypoint.time)[0], waypoint.welding ? 1 : 0) << waypoint.time;
  EXPECT_EQ(columns.values(-0.01)[0], 0);
  EXPECT_EQ(columns.values(3.21)[0], 1);
}

TEST(PaceCheck, OwnLawPasses) {
  const Problem problem = problem_of(description());
  const TrajectoryFile file = file_of(problem.task);
  const Verification with_law = check(problem, file);
  EXPECT_TRUE(with_law.passed) << testing::PrintToString(with_law.failures);
  TrajectoryFile without = file;
  without.seam_time.reset();
  EXPECT_TRUE(check(problem, without).passed);
  TrajectoryFile points = file;
  points.trajectory.reset();
  EXPECT_TRUE(check(problem, points).passed);
}

TEST(PaceCheck, WeldSpeedIsHeldUnlessTheProblemSaysOtherwise) {
  EXPECT_TRUE(check_straight(law({{0, 0, 1}, {10, 10, 1}})).passed);
  const Trajectory slower = law({{0, 0, 1}, {4, 4, 1}, {5, 4.75, 0.5}, {6, 5.5, 1}, {10.5, 10, 1}});
  expect_failure(check_straight(slower), {"0.5 times its speed at t = 5 s", "asks for 1"});
  EXPECT_TRUE(check_straight(slower, SpeedPolicy::slow).passed);
  // Slower only between two knots, at which the speed is right.
  expect_failure(check_straight(law({{0, 0, 1}, {4, 4, 1}, {5, 4.9, 1}, {10.1, 10, 1}})),
                 {"times its speed"});
}

TEST(PaceCheck, NeverFasterThanTheWeldSpeed) {
  for (const SpeedPolicy policy : {SpeedPolicy::hold, SpeedPolicy::slow}) {
    const Verification result = check_straight(
        law({{0, 0, 1}, {4, 4, 1}, {5, 5.05, 1.1}, {6, 6.1, 1}, {9.9, 10, 1}}), policy);
    expect_failure(result, {"runs the seam at 1.1", "after t = 4"});
  }
}

TEST(PaceCheck, NeverBackAndOverTheWholeSeam) {
  expect_failure(check_straight(law({{0, 0, 1}, {4, 4, 1}, {5, 3.9, 1}, {11.1, 10, 1}})),
                 {"runs back after t = 4"});
  expect_failure(check_straight(law({{0, 0, 1}, {9, 9, 1}})), {"from 0 s to 9 s", "10 s"});
  expect_failure(check_straight(law({{0, 1, 1}, {9, 10, 1}})), {"from 1 s to 10 s"});
}

TEST(PaceCheck, StopOfTheProblemIsNotToBeLeftOutOrMadeLonger) {
  const Problem problem = problem_of(description());
  // As if there were no corner.
  const double end = problem.task.seam.pieces().back().end_time;
  TrajectoryFile file;
  file.seam_time = law({{-2, -2, 1}, {end, end, 1}});
  const Task even = problem.task.retimed(*file.seam_time);
  file.path = along(even, waypoint_times(even)).waypoints();
  expect_failure(check(problem, file), {"1 times its speed at t = 10 s", "asks for 0"});

  SeamDescription longer = description();
  longer.corners.ramp_time = 1;
  expect_failure(check(problem, file_of(problem_of(longer).task)), {"times its speed at t = "});
  SeamDescription shorter = description();
  shorter.corners.ramp_time = 0.25;
  EXPECT_TRUE(check(problem, file_of(problem_of(shorter).task)).passed);
}

TEST(RestCheck, OfBothEnds) {
  const Problem problem = problem_of(description());
  const Trajectory motion = along(problem.task, waypoint_times(problem.task));
  EXPECT_TRUE(check(problem, motion).passed);
  for (const bool at_end : {false, true}) {
    for (const bool faulty_speed : {true, false}) {
      auto velocities = motion.velocities(), accelerations = motion.accelerations();
      auto& planted = faulty_speed ? velocities : accelerations;
      (at_end ? planted.back() : planted.front())[1] = 2e-6;
      const Trajectory faulty(motion.times(), motion.positions(), velocities, accelerations);
      expect_failure(check(problem, faulty),
                     {"joint y is not at rest", faulty_speed ? "speed 2e-06" : "acceleration 2e-06",
                      at_end ? "t = 19.5" : "t = -2"});
      Problem moving = problem;
      (at_end ? moving.task.rest_at_end : moving.task.rest_at_start) = false;
      EXPECT_TRUE(check(moving, faulty).passed);
    }
  }
}

/// A row between two waypoints that is outside the box, but inside it widened by `between`.
TEST(RowWaypoints, OtherRowsAreKnots) {
  const Problem problem = problem_of(describe({line(at(0, 0, 0), at(0.1, 0, 0))}));
  std::vector<double> times = waypoint_times(problem.task);
  times.insert(times.begin() + 4, 1.7);
  Trajectory motion = along(problem.task, times);
  auto positions = motion.positions();
  positions[4][1] = 5e-5;
  const auto moved = [&] {
    return Trajectory(motion.times(), positions, motion.velocities(), motion.accelerations());
  };
  EXPECT_TRUE(check(problem, moved()).passed);
  positions[4][1] = 2e-4;
  expect_failure(check(problem, moved()), {"between waypoints", "y is"});
  // Without one of the waypoints every row counts as a waypoint.
  positions[4][1] = 5e-5;
  times.erase(times.begin() + 5);
  positions.erase(positions.begin() + 5);
  motion = along(problem.task, times);
  expect_failure(check(problem, moved()), {"waypoint 4", "y is"});
}

TEST(RowWaypoints, KnotsMayLieOnMoves) {
  JointVector q(3);
  q << 0.1, 0.1, 0.1;
  const Segment joints{JointListSegment{{JointBox(q)}, {"away"}}, {}, "joints"};
  const Task task = problem_of(describe({line(at(0, 0, 0), at(0.1, 0, 0)), joints})).task;
  std::vector<double> times = waypoint_times(task);
  times.insert(times.end() - 1, times.back() - 0.5);
  const RowWaypoints rows = row_waypoints(task, times);
  ASSERT_EQ(rows.task.waypoints.size(), times.size());
  for (std::size_t i = 0; i < times.size(); ++i) {
    EXPECT_EQ(rows.is_knot[i], i == times.size() - 2);
    EXPECT_EQ(rows.task.waypoints[i].time, times[i]);
  }
  EXPECT_FALSE(rows.task.waypoints[times.size() - 2].joints);
  EXPECT_TRUE(rows.task.waypoints.back().joints);
  EXPECT_FALSE(rows.task.tolerance_between(times.size() - 2));
}

TEST(RowWaypoints, KnotsOfARunHaveItsBox) {
  const Task task = problem_of(description()).task;
  std::vector<double> times = waypoint_times(task);
  const auto start = std::find(times.begin(), times.end(), 0.0);
  const auto index = static_cast<std::size_t>(start - times.begin());
  times.insert(start, -0.1);
  const RowWaypoints rows = row_waypoints(task, times);
  EXPECT_TRUE(rows.is_knot[index]);
  EXPECT_NEAR(rows.task.tolerance_between(index)->upper[0], 1e-3, 1e-15);
  EXPECT_NEAR(rows.task.tolerance_between(index - 1)->upper[0], 1e-3, 1e-15);
  EXPECT_EQ(rows.task.tolerance_between(index + 1)->upper[0], 0);
}

}  // namespace
}  // namespace wristwise
