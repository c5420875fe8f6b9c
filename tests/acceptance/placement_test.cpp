// place() on a short seam, against placements that are loaded, planned and measured one by one.

#include "wristwise/placement.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <memory>

#include "invalid_input.hpp"
#include "placement_example.hpp"

namespace wristwise {
namespace {

using test::invalid_input;
using test::placement_request;
using test::placement_text;
using test::replaced;
using test::says;
using test::TemporaryFolder;

constexpr double kNotWeldable = 1000;

/// Distances that move with the seam: of the plate, or of task C's profile.
bool is_tool_at_part(const ClearanceModel& model, int pair) {
  const auto& [body_a, shape_a, body_b, shape_b] = model.pairs()[static_cast<std::size_t>(pair)];
  const auto& a = model.bodies()[static_cast<std::size_t>(body_a)];
  const auto& b = model.bodies()[static_cast<std::size_t>(body_b)];
  for (const char* part : {"plate", "foot", "upright"})
    if ((a.joint == 5 && b.name == part) || (b.joint == 5 && a.name == part)) return true;
  return false;
}

/// (F81) by its definition, at 301 times: the wrist's distance from singularity from joint 5, whose
/// axis is at a right angle to its neighbours'; distances of all pairs but the tool's from the
/// plate, which moves with the seam.
double measured(const Problem& problem, const PlanResult& plan, const PlacementOptions& options) {
  if (plan.status != Status::solved) return kNotWeldable;
  constexpr double kFar = 0.1;  // m, beyond all margins
  ClearanceChecker checker(std::make_shared<const ClearanceModel>(problem.robot, problem.scene));
  double speed = 0, wrist = 1, clearance = kFar;
  const std::vector<double>& times = plan.trajectory.times();
  for (int k = 0; k <= 300; ++k) {
    const double t = times.front() + k * (times.back() - times.front()) / 300;
    const JointVector v = plan.trajectory.evaluate(t, 1).cwiseAbs();
    speed = std::max(speed, v.cwiseQuotient(problem.robot->velocity_limits()).maxCoeff());
    const JointVector q = plan.trajectory.evaluate(t);
    wrist = std::min(wrist, std::abs(std::sin(q[4])));
    checker.set_posture(q);
    for (int pair = 0; pair < static_cast<int>(checker.model().pairs().size()); ++pair) {
      if (is_tool_at_part(checker.model(), pair)) continue;
      if (checker.lower_bound(pair, kFar) < kFar)
        clearance = std::min(clearance, checker.distance(pair).distance);
    }
  }
  const auto missing = [](double has, double wanted) {
    return std::max(0.0, 1 - std::max(0.0, has) / wanted);
  };
  return options.speed_weight * speed +
         options.singularity_weight * missing(wrist, options.singularity_margin) +
         options.clearance_weight *
             missing(clearance - problem.scene.clearance, options.clearance_margin);
}

/// The problem file with part and plate elsewhere, written by hand.
Problem problem_at(const TemporaryFolder& folder, double x, double y) {
  std::string text = placement_text("{with: [plate]}");
  text = replaced(text, "frame: {xyz: [1.0, 0, 0.8]}",
                  fmt::format("frame: {{xyz: [{}, {}, 0.8]}}", 1 + x, y));
  text = replaced(text, "xyz: [1.0, 0, 0.79]", fmt::format("xyz: [{}, {}, 0.79]", 1 + x, y));
  return load_problem(folder.write("by_hand.yaml", text));
}

PlanOptions one_thread() {
  PlanOptions options;
  options.threads = 1;
  return options;
}

/// The region reaches beyond the reach and over the pillar.
TEST(Placement, NoPlacementOfAGridIsBetter) {
  const TemporaryFolder folder;
  const PlacementRequest request = placement_request(
      folder, "{with: [plate], x: [-0.2, 0.8], y: [-0.7, 0.3], map: 8, evaluations: 120}");
  const PlacementResult result = place(request);
  ASSERT_EQ(result.status, Status::solved);
  ASSERT_EQ(result.map.samples.size(), 64U);
  int feasible = 0;
  for (const Placement& sample : result.map.samples) {
    const Problem problem = problem_at(folder, sample.offset[0], sample.offset[1]);
    const double value = measured(problem, plan(problem, one_thread()), request.options);
    feasible += value < kNotWeldable ? 1 : 0;
    if (sample.measure.obstacle == "standing_contact") {  // no plan sees the plate in the pillar
      EXPECT_LT((sample.offset.head<2>() - Eigen::Vector2d(0.2, -0.5)).norm(), 0.15);
      continue;
    }
    EXPECT_EQ(sample.measure.feasible, value < kNotWeldable) << sample.offset.transpose();
    if (value < kNotWeldable) {
      EXPECT_NEAR(sample.measure.value, value, 5e-3);  // the wrist between two ticks
    }
    EXPECT_LE(result.found.measure.value, value + 1e-3) << sample.offset.transpose();
  }
  EXPECT_GT(feasible, 10);
  EXPECT_LT(feasible, 60);
  EXPECT_LT(result.found.measure.value, 0.1 * result.given.measure.value);

  const Problem there = problem_at(folder, result.found.offset[0], result.found.offset[1]);
  const PlanResult replanned = plan(there);
  EXPECT_EQ(replanned.status, Status::solved);
  EXPECT_NEAR(measured(there, replanned, request.options), result.found.measure.value, 1e-4);
  EXPECT_TRUE(result.after.two_stage.verification.passed);
}

/// A pillar where the best place was.
TEST(Placement, WhatStandsInTheWayIsGoneAround) {
  const TemporaryFolder folder;
  const std::string section = "{with: [plate], y: [-0.35, 0.1], x: 0.1, map: off, evaluations: 80}";
  const PlacementResult free = place(placement_request(folder, section));
  ASSERT_EQ(free.status, Status::solved);
  const Offset best = free.found.offset;
  const std::string blocked =
      replaced(placement_text(section), "cylinder: [0.03, 0.6], xyz: [1.2, -0.5, 0.3]",
               fmt::format("cylinder: [0.03, 0.6], xyz: [{}, {}, 0.8]", 1 + best[0], best[1]));
  const PlacementResult result = place(load_placement(folder.write("b.yaml", blocked)));
  ASSERT_EQ(result.status, Status::solved);
  EXPECT_GT((result.found.offset - best).norm(), 0.05);
  EXPECT_GT(result.found.measure.value, free.found.measure.value);
  EXPECT_LT(result.obstacles.at(""), result.evaluations);
}

/// The arm is the same on both sides, and so is a seam across its plane.
TEST(Placement, AMirroredPlacementIsAsGood) {
  const TemporaryFolder folder;
  const std::string text = replaced(placement_text("{with: all, y: 0.3, map: 7, evaluations: 40}"),
                                    "  clearance: 0.003\n", "  collision: off\n");
  const PlacementResult result = place(load_placement(folder.write("m.yaml", text)));
  ASSERT_EQ(result.status, Status::solved);
  ASSERT_EQ(result.map.samples.size(), 7U);
  for (std::size_t i = 0; i < 3; ++i) {
    const Placement &left = result.map.samples[i], &right = result.map.samples[6 - i];
    EXPECT_NEAR(left.offset[1], -right.offset[1], 1e-12);
    EXPECT_NEAR(left.measure.value, right.measure.value, 1e-3 * left.measure.value);
    EXPECT_FALSE(left.measure.clearance.has_value());
  }
}

TEST(Placement, WhereNothingIsInReachTheReasonIsTold) {
  const TemporaryFolder folder;
  const PlacementResult result = place(
      placement_request(folder, "{with: all, x: [1.0, 1.5], y: 0.2, evaluations: 40, map: 3}"));
  EXPECT_EQ(result.status, Status::infeasible);
  EXPECT_EQ(result.after.placed.problem.robot, nullptr);
  EXPECT_EQ(result.obstacles.at("out_of_reach"), result.evaluations);
  ASSERT_EQ(result.diagnosis.size(), 2U);
  EXPECT_TRUE(says(result.diagnosis[0].detail, "100% out_of_reach")) << result.diagnosis[0].detail;
  EXPECT_EQ(result.diagnosis[1].reason, "out_of_reach");
  EXPECT_NEAR(result.found.offset[0], 1.0, 0.05);  // least is missing where it is nearest
}

/// (F82) decreases on the way to where the seam can be welded.
TEST(Placement, WhatIsMissingLeadsToWhereThereIsNone) {
  const TemporaryFolder folder;
  const PlacementResult result =
      place(placement_request(folder, "{with: all, y: [0.2, 2.5], evaluations: 20, map: 60}"));
  double last = 0;
  bool partly = false;
  for (const Placement& sample : result.map.samples) {
    const PlacementMeasure& measure = sample.measure;
    if (measure.feasible) {
      EXPECT_LT(measure.value, 10);
      continue;
    }
    EXPECT_GT(measure.value, kNotWeldable);
    EXPECT_GE(measure.value, last - 1e-9) << sample.offset[1];
    partly = partly || (measure.waypoints_share > 0 && measure.waypoints_share < 1);
    last = measure.value;
  }
  EXPECT_GT(last, kNotWeldable + 2);
  EXPECT_TRUE(partly);
}

TEST(Placement, ARegionWithoutWidthIsTheGivenPlacement) {
  const TemporaryFolder folder;
  const PlacementResult result = place(placement_request(folder, "{with: all}"));
  EXPECT_EQ(result.status, Status::solved);
  EXPECT_EQ(result.found.offset, Offset::Zero());
  EXPECT_EQ(result.found.measure.value, result.given.measure.value);
  EXPECT_EQ(result.evaluations, 1U);
  EXPECT_TRUE(result.map.axes.empty());
}

TEST(Placement, AFixedCoordinateIsKept) {
  const TemporaryFolder folder;
  const PlacementResult result = place(placement_request(
      folder, "{with: all, x: [0.05, 0.05], y: [0.1, 0.2], evaluations: 20, map: off}"));
  EXPECT_EQ(result.status, Status::solved);
  EXPECT_EQ(result.found.offset[0], 0.05);
  EXPECT_GE(result.found.offset[1], 0.1);
  EXPECT_LE(result.found.offset[1], 0.2);
  EXPECT_EQ(result.given.offset, Offset::Zero());  // outside of the region
}

/// A limits file with a first joint that turns at 0.02 rad/s at most: too slow for the seam as it
/// is given, fast enough for it at the side.
std::string with_slow_joint(const TemporaryFolder& folder, std::string problem) {
  std::ifstream file(std::string(WRISTWISE_SOURCE_DIR) + "/robots/kuka_kr5_arc/joint_limits.yaml");
  const std::string limits{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  folder.write("slow.yaml",
               replaced(limits, "max_velocity: 2.6878070480712677", "max_velocity: 0.02"));
  const std::size_t start = problem.find("limits: ");
  return problem.replace(start, problem.find('\n', start) - start, "limits: slow.yaml");
}

TEST(Placement, ASeamTooFastForAJointIsPutWhereTheSpeedIsHeld) {
  const TemporaryFolder folder;
  const std::string text = with_slow_joint(
      folder, placement_text("{with: [plate], x: 0.2, y: [0, 0.4], map: off, evaluations: 16}"));
  const PlacementResult hold = place(load_placement(folder.write("hold.yaml", text)));
  EXPECT_FALSE(hold.given.measure.feasible);
  EXPECT_EQ(hold.given.measure.obstacle, "infeasible_at_this_speed");
  EXPECT_GT(hold.given.measure.value, kNotWeldable);
  EXPECT_LT(hold.given.measure.value, kNotWeldable + 1);
  ASSERT_EQ(hold.status, Status::solved);
  EXPECT_LE(hold.found.measure.speed_ratio, 1 + 1e-9);

  // run slower, it can be welded as it is given, but that is worth less: 1.4 times the limit
  const PlacementResult slow = place(load_placement(
      folder.write("slow_policy.yaml",
                   replaced(text, "  speed: 0.02\n", "  speed: 0.02\n  speed_policy: slow\n"))));
  EXPECT_TRUE(slow.given.measure.feasible);
  EXPECT_NEAR(slow.given.measure.speed_ratio, 1.4, 0.1);
  ASSERT_EQ(slow.status, Status::solved);
  EXPECT_LE(slow.found.measure.speed_ratio, 1 + 1e-9);
}

TEST(Placement, NoMoreIsMeasuredThanAskedFor) {
  const TemporaryFolder folder;
  for (const int evaluations : {1, 3, 10}) {
    PlacementRequest request = placement_request(folder, "{with: all, y: 0.2, map: off}");
    request.options.evaluations = evaluations;
    const PlacementResult result = place(request);
    EXPECT_EQ(result.status, Status::solved);
    EXPECT_LE(result.evaluations, static_cast<std::size_t>(evaluations));
    EXPECT_GE(result.evaluations, static_cast<std::size_t>(evaluations + 1) / 2);
  }
}

TEST(Placement, ARobotElsewhereIsWorthAsMuchAsAllElseMovedBack) {
  const TemporaryFolder folder;
  const PlacementResult robot = place(
      placement_request(folder, "{move: robot, x: [0.05, 0.05], y: [-0.1, -0.1], rz: [0.2, 0.2]}"));
  PlacementRequest request = placement_request(folder, "{with: all}");
  request.part_frame = Pose::Identity();  // turns about the base
  const Pose back = pose_from_xyz_rpy({0.05, -0.1, 0}, {0, 0, 0.2}).inverse();
  request.options.lower << back.translation(), 0, 0, -0.2;
  request.options.upper = request.options.lower;
  const PlacementResult part = place(request);
  ASSERT_EQ(robot.status, Status::solved);
  EXPECT_NEAR(robot.found.measure.value, part.found.measure.value, 1e-9);
}

TEST(Placement, TheNumberOfThreadsDoesNotMatterTheSeedDoes) {
  const TemporaryFolder folder;
  PlacementRequest request = placement_request(
      folder, "{with: [plate], x: 0.2, y: 0.3, rz: 20 deg, evaluations: 60, map: 4}");
  PlanOptions three;
  three.threads = 3;
  const PlacementResult a = place(request, one_thread()), b = place(request, three);
  EXPECT_EQ(a.found.offset, b.found.offset);
  EXPECT_EQ(a.found.measure.value, b.found.measure.value);
  EXPECT_EQ(a.obstacles, b.obstacles);
  for (std::size_t i = 0; i < a.map.samples.size(); ++i)
    EXPECT_EQ(a.map.samples[i].measure.value, b.map.samples[i].measure.value);
  request.options.seed = 2;
  request.options.evaluations = 20;
  const PlacementResult c = place(request, one_thread());
  EXPECT_NE(a.found.offset, c.found.offset);
}

TEST(Placement, StopsWhenCancelled) {
  const TemporaryFolder folder;
  std::atomic<bool> cancel{false};
  int reports_after = 0;
  PlanOptions options = one_thread();
  options.monitor.cancel = &cancel;
  options.monitor.progress = [&](const std::string& stage, double fraction) {
    reports_after += cancel ? 1 : 0;
    if (stage == "search" && fraction > 0.05) cancel = true;
  };
  const PlacementResult result =
      place(placement_request(folder, "{with: [plate], x: 0.2, y: 0.3}"), options);
  EXPECT_EQ(result.status, Status::interrupted);
  EXPECT_LE(reports_after, 1);
}

TEST(Placement, WithoutTimeTheGivenPlacementIsWhatThereIs) {
  const TemporaryFolder folder;
  PlacementRequest request =
      placement_request(folder, "{with: [plate], x: 0.2, y: 0.3, time_limit: 1e-9}");
  const PlacementResult inside = place(request);
  EXPECT_EQ(inside.status, Status::solved);
  EXPECT_TRUE(inside.out_of_time);
  EXPECT_EQ(inside.found.offset, Offset::Zero());
  request.options.lower[0] = 0.1;  // the given placement is no longer inside
  const PlacementResult outside = place(request);
  EXPECT_EQ(outside.status, Status::infeasible);
  EXPECT_EQ(outside.diagnosis.at(0).reason, "time_limit");
}

TEST(Placement, BadRequestsAreRefused) {
  const TemporaryFolder folder;
  const PlacementRequest good = placement_request(folder, "{with: [plate], x: 0.1}");
  const auto refused = [&](const std::string& part, const auto& spoil) {
    PlacementRequest request = good;
    spoil(request);
    EXPECT_TRUE(says(invalid_input([&] { place(request); }), part)) << part;
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  refused("placement.y", [&](auto& r) { r.options.lower[1] = nan; });
  refused("placement.z", [&](auto& r) { r.options.upper[2] = infinite; });
  refused("placement.x", [](auto& r) { r.options.lower[0] = 0.2; });
  refused("no object 'plane'", [](auto& r) { r.options.with = {"plane"}; });
  refused("twice", [](auto& r) { r.options.with = {"plate", "plate"}; });
  refused("weights.speed", [&](auto& r) { r.options.speed_weight = nan; });
  refused("margins.singularity", [](auto& r) { r.options.singularity_margin = 2; });
  refused("margins.clearance", [](auto& r) { r.options.clearance_margin = -1; });
  refused("evaluations", [](auto& r) { r.options.evaluations = -1; });
  refused("map", [](auto& r) { r.options.map_points = -1; });
  refused("time_limit", [&](auto& r) { r.options.time_limit = nan; });
  refused("task_after", [](auto& r) { r.task_after = nullptr; });
}

double peak_speed(const JointPath& path, int joint) {
  double peak = 0;
  for (std::size_t i = 1; i < path.size(); ++i)
    peak = std::max(peak, std::abs(path.positions[i][joint] - path.positions[i - 1][joint]) /
                              (path.times[i] - path.times[i - 1]));
  return peak;
}

/// The seam of task C with the torch at its nominal orientation throughout.
JointPath constant_orientation(Problem problem) {
  for (Waypoint& waypoint : problem.task.waypoints)
    waypoint.tolerance.lower = waypoint.tolerance.upper = Vector6::Zero();
  const PlanResult result = plan_graph_only(problem);
  EXPECT_EQ(result.status, Status::solved);
  return result.path;
}

/// The shipped problem is one that task C's own search leads to.
TEST(Placement, TheShippedPlacementOfTaskCHasNoSpikeToBeginWith) {
  const auto shipped = [](const std::string& name) {
    return load_problem(std::string(WRISTWISE_SOURCE_DIR) + "/problems/" + name + ".yaml");
  };
  const Problem given = shipped("task_c_wrist_singularity"), there = shipped("task_c_placed");
  const PlanResult before = plan(given), after = plan(there);
  ASSERT_EQ(after.status, Status::solved);
  EXPECT_LT(measured(there, after, {}), 0.01);
  EXPECT_GT(measured(given, before, {}), 0.9);
  for (const int joint : {3, 5})
    EXPECT_GT(peak_speed(constant_orientation(given), joint),
              30 * peak_speed(constant_orientation(there), joint));
}

/// Joints 4 and 6 run away from each other where task C is; not where it is put.
TEST(Placement, TaskCIsPutWhereItHasNoSpike) {
  PlacementRequest request =
      load_placement(std::string(WRISTWISE_SOURCE_DIR) + "/problems/task_c_wrist_singularity.yaml");
  request.options.evaluations = 60;
  request.options.map_points = 0;
  const PlacementResult result = place(request);
  ASSERT_EQ(result.status, Status::solved);
  EXPECT_LT(result.given.measure.singularity_distance, 0.01);
  EXPECT_GE(result.found.measure.singularity_distance, 0.45);
  const JointPath before = constant_orientation(result.before.placed.problem);
  const JointPath after = constant_orientation(result.after.placed.problem);
  for (const int joint : {3, 5}) {
    EXPECT_GT(peak_speed(before, joint), 0.3);
    EXPECT_LT(peak_speed(after, joint), 0.03);
  }
}

}  // namespace
}  // namespace wristwise
