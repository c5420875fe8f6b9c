#include "io/result_file.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "temporary_folder.hpp"
#include "wristwise/trajectory_file.hpp"

namespace wristwise {
namespace {

using Json = nlohmann::ordered_json;
using test::file_text;
using test::TemporaryFolder;

Problem slider_problem() {
  Robot::Parts parts;
  parts.base_link = "base";
  parts.tip_link = "tip";
  Joint joint;
  joint.name = "slide";
  joint.type = JointType::prismatic;
  joint.lower = -10;
  joint.upper = 10;
  joint.max_velocity = 1;
  joint.max_acceleration = joint.max_jerk = std::numeric_limits<double>::infinity();
  parts.joints.push_back(joint);
  Problem problem;
  problem.name = "slider";
  problem.robot = std::make_shared<const Robot>(parts);
  return problem;
}

JointVector value(double x) { return JointVector::Constant(1, x); }

/// q = t^2 at 0, 1, 3 s.
PlanResult parabola() {
  PlanResult result;
  result.path = {{0, 1, 3}, {value(0), value(1), value(9)}};
  return result;
}

std::vector<std::string> keys(const Json& json) {
  std::vector<std::string> names;
  for (const auto& item : json.items()) names.push_back(item.key());
  return names;
}

void expect_first_keys(const Json& json, const std::vector<std::string>& expected) {
  std::vector<std::string> found = keys(json);
  ASSERT_GE(found.size(), expected.size());
  found.resize(expected.size());
  EXPECT_EQ(found, expected);
}

TEST(ResultFile, SaysWhereTheWeldIsSlowed) {
  PlanResult result = parabola();
  Json held = Json::parse(result_json(result, slider_problem()))["speed_held"];
  EXPECT_EQ(held["slowest"], 1);
  EXPECT_TRUE(held["slowed"].empty());
  result.slowed = {{0.5, 1.5, 0.25, 0}, {2, 3, 0.75, 0}};
  held = Json::parse(result_json(result, slider_problem()))["speed_held"];
  EXPECT_EQ(held["slowest"], 0.25);
  ASSERT_EQ(held["slowed"].size(), 2U);
  EXPECT_EQ(held["slowed"][0],
            Json({{"from_s", 0.5}, {"to_s", 1.5}, {"least_ratio", 0.25}, {"joint", "slide"}}));
  EXPECT_EQ(held["slowed"][1]["to_s"], 3);
}

TEST(ResultFile, HasTheKeysOfTheContract) {
  PlanResult result = parabola();
  result.mode = Mode::smooth;  // the rows are the waypoints
  result.refine.terms = {{"jerk", 3, 1}};
  result.diagnosis.push_back({std::size_t{7}, "collision", "detail", "suggestion"});
  const Json json = Json::parse(result_json(result, slider_problem()));
  expect_first_keys(json, {"status", "mode", "waypoints", "joints", "timing_s", "peak_rss_bytes",
                           "graph", "refine", "peaks", "verification", "speed_held", "diagnosis"});
  expect_first_keys(json["timing_s"], {"load", "sampling", "search", "refine", "verify", "total"});
  expect_first_keys(json["graph"], {"vertices", "edges", "edges_evaluated", "collision_checks",
                                    "cost", "joint_motion_l1"});
  expect_first_keys(json["refine"],
                    {"iterations", "evaluations", "termination", "objective", "terms"});
  expect_first_keys(json["refine"]["terms"][0], {"name", "initial", "final"});
  expect_first_keys(json["peaks"]["slide"], {"velocity", "acceleration", "jerk"});
  expect_first_keys(json["verification"],
                    {"passed", "position_error_m", "tolerance_excess", "clearance_m",
                     "clearance_pair", "clearance_time_s", "joint_limit_excess", "velocity_ratio",
                     "acceleration_ratio", "jerk_ratio", "samples"});
  expect_first_keys(json["speed_held"], {"ratio", "worst_time_s", "worst_joint"});
  expect_first_keys(json["diagnosis"][0], {"waypoint", "reason", "detail", "suggestion"});
  EXPECT_EQ(json["diagnosis"][0]["waypoint"], 7);
  EXPECT_EQ(json["waypoints"], 3);
  EXPECT_EQ(json["joints"], Json::array({"slide"}));
  EXPECT_GT(json["peak_rss_bytes"], 1'000'000);
}

TEST(ResultFile, SaysOfEverySeedWhatStage2MadeOfIt) {
  PlanResult result = parabola();
  EXPECT_TRUE(Json::parse(result_json(result, slider_problem()))["graph"]["seeds"].empty());
  result.seeds.resize(3);
  result.seeds[0].cost = 1.5;
  result.seeds[0].refinement = "the constraints can't be met together";
  result.seeds[1].cost = 2;
  result.seeds[1].differs_at = 4;
  result.seeds[1].refinement = "converged";
  result.seeds[1].objective = 0.25;
  const Json seeds = Json::parse(result_json(result, slider_problem()))["graph"]["seeds"];
  EXPECT_EQ(
      seeds,
      Json::array(
          {{{"cost", 1.5},
            {"differs_at", 0},
            {"refinement", "the constraints can't be met together"},
            {"objective", nullptr}},
           {{"cost", 2.0}, {"differs_at", 4}, {"refinement", "converged"}, {"objective", 0.25}},
           {{"cost", 0.0}, {"differs_at", 0}, {"refinement", "not run"}, {"objective", nullptr}}}));
}

TEST(ResultFile, NamesOfStatusAndMode) {
  PlanResult result;
  const Problem problem = slider_problem();
  const std::vector<std::pair<Status, std::string>> statuses = {
      {Status::solved, "solved"},
      {Status::infeasible, "infeasible"},
      {Status::failed, "failed"},
      {Status::interrupted, "interrupted"}};
  for (const auto& [status, name] : statuses) {
    result.status = status;
    EXPECT_EQ(Json::parse(result_json(result, problem))["status"], name);
  }
  const std::vector<std::pair<Mode, std::string>> modes = {
      {Mode::two_stage, "two-stage"}, {Mode::graph_only, "graph-only"}, {Mode::smooth, "smooth"}};
  for (const auto& [mode, name] : modes) {
    result.mode = mode;
    EXPECT_EQ(Json::parse(result_json(result, problem))["mode"], name);
  }
}

TEST(ResultFile, PeaksAreDividedDifferencesWithTheRealTimeSteps) {
  const Json peaks = Json::parse(result_json(parabola(), slider_problem()))["peaks"]["slide"];
  EXPECT_DOUBLE_EQ(peaks["velocity"], 4.0);      // (9 - 1) / 2
  EXPECT_DOUBLE_EQ(peaks["acceleration"], 2.0);  // of t^2
  EXPECT_TRUE(peaks["jerk"].is_null());
}

TEST(ResultFile, WhatIsUnknownIsNull) {
  PlanResult result;
  result.refine.run = true;
  result.refine.objective = std::numeric_limits<double>::quiet_NaN();
  result.graph.cost = std::numeric_limits<double>::infinity();
  const Json json = Json::parse(result_json(result, Problem()));
  EXPECT_TRUE(json["refine"]["objective"].is_null());
  EXPECT_TRUE(json["graph"]["cost"].is_null());
  EXPECT_TRUE(json["verification"]["clearance_m"].is_null());
  EXPECT_TRUE(json["verification"]["clearance_pair"].is_null());
  EXPECT_TRUE(json["verification"]["velocity_ratio"].is_null());
  EXPECT_TRUE(json["speed_held"]["worst_joint"].is_null());
  EXPECT_EQ(json["verification"]["passed"], false);
  EXPECT_EQ(json["joints"], Json::array());
}

TEST(ResultFile, VerificationIsTranscribed) {
  PlanResult result = parabola();
  Verification& v = result.verification;
  v.range = {0, 3};
  v.clearance_not_shown = {{{1, 1.5}, {"torch", "plate"}}};
  v.deviation_not_shown = {{2, 2.5}};
  v.path_error = 1e-4;
  v.angle_error = 2e-3;
  v.run = v.passed = v.curve = true;
  v.position_error = 1e-7;
  v.tolerance_excess << 1, 2, 3, 4, 5, 6;
  v.clearance = 0.25;
  v.clearance_pair = {"torch", "plate"};
  v.clearance_time = 1.5;
  v.velocity_ratio = 0.5;
  v.velocity_joint = 0;
  v.velocity_time = 2.5;
  v.samples = 11;
  const Json json = Json::parse(result_json(result, slider_problem()));
  EXPECT_EQ(json["verification"]["tolerance_excess"]["rz"], 6);
  EXPECT_EQ(json["verification"]["clearance_pair"], Json::array({"torch", "plate"}));
  EXPECT_EQ(json["verification"]["clearance_time_s"], 1.5);
  EXPECT_EQ(json["verification"]["samples"], 11);
  const Json certificate = json["verification"]["certificate"];
  EXPECT_EQ(certificate["from_s"], 0);
  EXPECT_EQ(certificate["to_s"], 3);
  EXPECT_EQ(certificate["shown"], false);
  EXPECT_TRUE(certificate["clearance_m"].is_null());
  EXPECT_EQ(certificate["epsilon_m"], 5e-5);
  EXPECT_EQ(certificate["not_shown"][0]["from_s"], 1);
  EXPECT_EQ(certificate["not_shown"][0]["to_s"], 1.5);
  EXPECT_EQ(certificate["not_shown"][0]["pair"], Json::array({"torch", "plate"}));
  EXPECT_EQ(certificate["tolerance_shown"], false);
  EXPECT_EQ(certificate["tolerance_not_shown"][0]["to_s"], 2.5);
  EXPECT_EQ(certificate["path_error_m"], 1e-4);
  EXPECT_EQ(certificate["path_error_rad"], 2e-3);
  EXPECT_EQ(json["speed_held"]["ratio"], 0.5);
  EXPECT_EQ(json["speed_held"]["worst_time_s"], 2.5);
  EXPECT_EQ(json["speed_held"]["worst_joint"], "slide");
  EXPECT_EQ(json["verification"], Json::parse(verification_json(v, slider_problem())));
}

TEST(ResultFile, SmoothHasBeforeAndAfter) {
  PlanResult result = parabola();
  result.mode = Mode::smooth;
  EXPECT_TRUE(Json::parse(result_json(result, slider_problem()))["before"].is_null());
  result.before = {{{0, 1, 3, 4}, {value(0), value(1), value(9), value(9)}}, {}};
  result.before->verification.run = true;
  result.before->verification.failures = {"too fast"};
  result.before->verification.warnings = {"jerk"};
  EXPECT_TRUE(Json::parse(result_json(result, slider_problem()))["after"].is_null());
  // From rest to rest: 10 u^3 - 15 u^4 + 6 u^5.
  result.trajectory =
      Trajectory({0, 1}, {value(0), value(1)}, {value(0), value(0)}, {value(0), value(0)});
  result.verification.run = result.verification.curve = result.verification.passed = true;
  const Json json = Json::parse(result_json(result, slider_problem()));
  const Json& before = json["before"];
  const Json& after = json["after"];
  EXPECT_DOUBLE_EQ(before["peaks"]["slide"]["velocity"], 4.0);
  EXPECT_DOUBLE_EQ(before["peaks"]["slide"]["velocity_ratio"], 4.0);  // of 1 m/s
  EXPECT_EQ(before["violation_count"], 2);
  EXPECT_EQ(before["violations"], Json::array({"too fast", "jerk"}));
  EXPECT_EQ(before["verification"]["run"], true);
  EXPECT_NEAR(after["peaks"]["slide"]["velocity"], 15.0 / 8, 1e-12);  // at u = 1/2
  EXPECT_NEAR(after["peaks"]["slide"]["acceleration"], 10 / std::sqrt(3.0), 1e-12);
  EXPECT_NEAR(after["peaks"]["slide"]["jerk"], 60, 1e-12);  // at the ends
  EXPECT_EQ(after["peaks"]["slide"]["jerk_ratio"], 0);      // without a limit
  EXPECT_EQ(after["violation_count"], 0);
}

TEST(ResultFile, FilesOfAnEarlierResultDoNotSurvive) {
  const TemporaryFolder folder;
  const auto out = folder.path() / "deep" / "out";
  PlanResult result = parabola();
  result.trajectory = Trajectory(result.path.times, result.path.positions,
                                 {value(0), value(2), value(6)}, {value(2), value(2), value(2)});
  write_result(out, result, slider_problem());
  EXPECT_TRUE(read_trajectory(out / "trajectory.csv", {"slide"}).trajectory);
  EXPECT_TRUE(std::filesystem::exists(out / "trajectory_dense.csv"));

  write_result(out, parabola(), slider_problem());
  EXPECT_EQ(file_text(out / "trajectory.csv"), "time,slide\n0,0\n1,1\n3,9\n");
  EXPECT_FALSE(std::filesystem::exists(out / "trajectory_dense.csv"));

  write_result(out, PlanResult(), slider_problem());
  EXPECT_FALSE(std::filesystem::exists(out / "trajectory.csv"));
  EXPECT_TRUE(std::filesystem::exists(out / "result.json"));
}

/// A weld of 10 s on a slide with a run-in of 2 s and a run-out of 1 s.
TEST(ResultFile, RunInAndRunOutAreNoWaypointsOfTheWeld) {
  Problem problem = slider_problem();
  Json json = Json::parse(result_json(parabola(), problem));
  EXPECT_FALSE(json.contains("run_in_s"));
  EXPECT_FALSE(json.contains("run_out_s"));
  SeamPiece piece;
  piece.start_time = -2;
  piece.end_time = 11;
  problem.task.seam = Seam({piece});
  for (const double time : {-2, -1, 0, 5, 10, 11}) {
    Waypoint waypoint;
    waypoint.time = time;
    waypoint.welding = time >= 0 && time <= 10;
    problem.task.waypoints.push_back(waypoint);
  }
  problem.task.rest_at_start = problem.task.rest_at_end = true;
  PlanResult result;
  result.mode = Mode::graph_only;
  json = Json::parse(result_json(result, problem));
  EXPECT_EQ(json["waypoints"], 3);
  EXPECT_EQ(json["run_in_s"], 2);
  EXPECT_EQ(json["run_out_s"], 1);
  problem.task.rest_at_end = false;
  EXPECT_FALSE(Json::parse(result_json(result, problem)).contains("run_out_s"));
}

}  // namespace
}  // namespace wristwise
