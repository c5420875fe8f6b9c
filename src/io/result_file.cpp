#include "io/result_file.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "io/peaks.hpp"
#include "io/text_file.hpp"
#include "wristwise/trajectory_file.hpp"

namespace wristwise {

namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json number(const std::optional<double>& value) { return value ? number(*value) : Json(nullptr); }

/// A count that may not fit an integer.
Json count(double value) {
  constexpr double kLargest = 9007199254740992.0;  // 2^53: beyond it doubles skip integers
  if (value >= 0 && value < kLargest && value == std::floor(value))
    return static_cast<std::int64_t>(value);
  return number(value);
}

Json joint_name(const Problem& problem, int joint) {
  if (!problem.robot || joint < 0 || joint >= problem.robot->joint_count()) return nullptr;
  return problem.robot->joints()[static_cast<std::size_t>(joint)].name;
}

Json names(const ClearanceModel::Names& pair) {
  if (pair.first.empty() && pair.second.empty()) return nullptr;
  return Json::array({pair.first, pair.second});
}

Json coordinates(const Vector6& values) {
  Json json = Json::object();
  for (int i = 0; i < 6; ++i)
    json[kCoordinateNames[static_cast<std::size_t>(i)]] = number(values[i]);
  return json;
}

Json peak_rss_bytes() {
  rusage usage{};
  if (getrusage(RUSAGE_SELF, &usage) != 0) return nullptr;
  return static_cast<std::int64_t>(usage.ru_maxrss) * 1024;
}

Json timing(const Timing& timing) {
  return {{"load", number(timing.load)},     {"sampling", number(timing.sampling)},
          {"search", number(timing.search)}, {"refine", number(timing.refine)},
          {"verify", number(timing.verify)}, {"total", number(timing.total)}};
}

Json seeds(const PlanResult& result) {
  Json json = Json::array();
  for (const Seed& seed : result.seeds) {
    json.push_back({{"cost", number(seed.cost)},
                    {"differs_at", seed.differs_at},
                    {"refinement", seed.refinement},
                    {"objective", number(seed.objective)}});
  }
  return json;
}

Json graph(const PlanResult& result) {
  const GraphStatistics& graph = result.graph;
  return {{"vertices", graph.vertices},
          {"edges", count(graph.edges)},
          {"edges_evaluated", count(graph.edges_evaluated)},
          {"collision_checks", graph.collision_checks},
          {"cost", number(graph.cost)},
          {"joint_motion_l1", number(graph.joint_motion_l1)},
          {"edges_checked", graph.edges_checked},
          {"edges_checked_if_eager", count(graph.edges_if_eager)},
          {"postures", graph.postures},
          {"postures_checked", graph.postures_checked},
          {"postures_checked_if_eager", graph.postures},
          {"first_turns", graph.first_turns},
          {"last_turns", graph.last_turns},
          {"grid_rounds", graph.grid_rounds},
          {"first_cost", number(graph.first_cost)},
          {"sparse_points", graph.sparse_points},
          {"replans", graph.replans},
          {"pieces", graph.pieces},
          {"seeds", seeds(result)}};
}

std::string unit_name(ActiveConstraint::Unit unit) {
  switch (unit) {
    case ActiveConstraint::Unit::metre:
      return "m";
    case ActiveConstraint::Unit::radian:
      return "rad";
    case ActiveConstraint::Unit::share:
      break;
  }
  return "share of the limit";
}

Json active(const std::vector<ActiveConstraint>& constraints) {
  Json json = Json::array();
  for (const ActiveConstraint& constraint : constraints) {
    json.push_back({{"name", constraint.name},
                    {"from_s", number(constraint.from)},
                    {"to_s", number(constraint.to)},
                    {"relative_gain", number(constraint.relative_gain)},
                    {"per", unit_name(constraint.unit)},
                    {"sentence", constraint.sentence}});
  }
  return json;
}

Json refine(const RefineStatistics& refine) {
  Json terms = Json::array();
  for (const CostTerm& term : refine.terms)
    terms.push_back(
        {{"name", term.name}, {"initial", number(term.initial)}, {"final", number(term.final)}});
  return {{"iterations", refine.iterations},
          {"evaluations", refine.evaluations},
          {"termination", refine.run ? refine.termination : "not run"},
          {"objective", refine.run ? number(refine.objective) : Json(nullptr)},
          {"terms", std::move(terms)},
          {"rounds", refine.rounds},
          {"control_points", refine.control_points},
          {"constraint_points", refine.constraint_points},
          {"distance_queries", refine.distance_queries},
          {"active", active(refine.active)},
          {"max_violation", refine.run ? number(refine.max_violation) : Json(nullptr)}};
}

Json peaks(const JointPath& path, const Problem& problem) {
  Json json = Json::object();
  if (!problem.robot) return json;
  const std::array<std::optional<JointVector>, 3> peaks = {
      peak_derivative(path, 1), peak_derivative(path, 2), peak_derivative(path, 3)};
  for (int j = 0; j < problem.robot->joint_count(); ++j) {
    const auto of_joint = [j](const std::optional<JointVector>& peak) {
      return peak ? number((*peak)[j]) : Json(nullptr);
    };
    json[problem.robot->joints()[static_cast<std::size_t>(j)].name] = {
        {"velocity", of_joint(peaks[0])},
        {"acceleration", of_joint(peaks[1])},
        {"jerk", of_joint(peaks[2])}};
  }
  return json;
}

/// What is shown for all t, and where it is not.
Json certificate(const Verification& verification, const Problem& problem) {
  const bool run = verification.run;
  Json clearance_not_shown = Json::array(), tolerance_not_shown = Json::array();
  for (const auto& [range, pair] : verification.clearance_not_shown) {
    clearance_not_shown.push_back(
        {{"from_s", number(range.from)}, {"to_s", number(range.to)}, {"pair", names(pair)}});
  }
  for (const TimeRange& range : verification.deviation_not_shown)
    tolerance_not_shown.push_back({{"from_s", number(range.from)}, {"to_s", number(range.to)}});
  const auto if_run = [run](const Json& value) { return run ? value : Json(nullptr); };
  return {{"from_s", if_run(number(verification.range.from))},
          {"to_s", if_run(number(verification.range.to))},
          {"shown",
           verification.clearance ? Json(verification.clearance_bound.has_value()) : Json(nullptr)},
          {"clearance_m", number(verification.clearance_bound)},
          {"epsilon_m", number(problem.refine.clearance_epsilon)},
          {"not_shown", std::move(clearance_not_shown)},
          {"tolerance_shown", if_run(verification.deviation_shown)},
          {"tolerance_not_shown", std::move(tolerance_not_shown)},
          {"path_error_m", if_run(number(verification.path_error))},
          {"path_error_rad", if_run(number(verification.angle_error))}};
}

Json verification_object(const Verification& verification, const Problem& problem) {
  const bool run = verification.run;
  const auto if_run = [run](double value) { return run ? number(value) : Json(nullptr); };
  return {
      {"passed", verification.passed},
      {"position_error_m", if_run(verification.position_error)},
      {"tolerance_excess", coordinates(verification.tolerance_excess)},
      {"clearance_m", number(verification.clearance)},
      {"clearance_pair", names(verification.clearance_pair)},
      {"clearance_time_s", verification.clearance ? number(verification.clearance_time) : nullptr},
      {"joint_limit_excess", if_run(verification.joint_limit_excess)},
      {"velocity_ratio", if_run(verification.velocity_ratio)},
      {"acceleration_ratio", if_run(verification.acceleration_ratio)},
      {"jerk_ratio", if_run(verification.jerk_ratio)},
      {"samples", verification.samples},
      {"distance_queries", verification.distance_queries},
      {"run", run},
      {"curve", verification.curve},
      {"tolerance_excess_between", coordinates(verification.tolerance_excess_between)},
      {"clearance_required_m", problem.scene.scope == CollisionScope::off
                                   ? Json(nullptr)
                                   : number(problem.scene.clearance)},
      {"clearance_bound_m", number(verification.clearance_bound)},
      {"clearance_epsilon_m", number(problem.refine.clearance_epsilon)},
      {"certificate", certificate(verification, problem)},
      {"velocity_joint", joint_name(problem, verification.velocity_joint)},
      {"acceleration_joint", joint_name(problem, verification.acceleration_joint)},
      {"jerk_joint", joint_name(problem, verification.jerk_joint)},
      {"failures", verification.failures},
      {"warnings", verification.warnings}};
}

/// The peaks of joint j: value and share of the limit for each of the three derivatives.
Json joint_peaks(const std::array<std::optional<JointVector>, 3>& peaks, const Robot& robot,
                 int j) {
  constexpr std::array<const char*, 3> kNames = {"velocity", "acceleration", "jerk"};
  Json json = Json::object();
  for (std::size_t k = 0; k < kNames.size(); ++k) {
    const double limit = derivative_limits(robot, static_cast<int>(k) + 1)[j];
    json[kNames[k]] = peaks[k] ? number((*peaks[k])[j]) : Json(nullptr);
    json[std::string(kNames[k]) + "_ratio"] =
        peaks[k] ? number((*peaks[k])[j] / limit) : Json(nullptr);
  }
  return json;
}

/// One side of before and after.
Json side(const std::array<std::optional<JointVector>, 3>& peaks, const Verification& verification,
          const Problem& problem) {
  Json joints = Json::object();
  for (int j = 0; j < problem.robot->joint_count(); ++j)
    joints[problem.robot->joints()[static_cast<std::size_t>(j)].name] =
        joint_peaks(peaks, *problem.robot, j);
  const std::vector<std::string> violations = violations_of(verification);
  return {{"peaks", std::move(joints)},
          {"violation_count", violations.size()},
          {"violations", violations},
          {"verification", verification_object(verification, problem)}};
}

/// What smooth was given, by divided differences.
Json before(const PlanResult& result, const Problem& problem) {
  if (!result.before || !problem.robot) return nullptr;
  const JointPath& path = result.before->path;
  return side({peak_derivative(path, 1), peak_derivative(path, 2), peak_derivative(path, 3)},
              result.before->verification, problem);
}

/// What it made of that, for all t.
Json after(const PlanResult& result, const Problem& problem) {
  if (!result.before || result.trajectory.empty() || !problem.robot) return nullptr;
  const Trajectory& curve = result.trajectory;
  return side({peak_derivative(curve, 1), peak_derivative(curve, 2), peak_derivative(curve, 3)},
              result.verification, problem);
}

Json speed_held(const PlanResult& result, const Problem& problem) {
  const Verification& verification = result.verification;
  const bool run = verification.run;
  Json slowed = Json::array();
  double slowest = 1;
  for (const SlowedStretch& stretch : result.slowed) {
    slowed.push_back({{"from_s", number(stretch.from)},
                      {"to_s", number(stretch.to)},
                      {"least_ratio", number(stretch.least_ratio)},
                      {"joint", joint_name(problem, stretch.joint)}});
    slowest = std::min(slowest, stretch.least_ratio);
  }
  return {{"ratio", run ? number(verification.velocity_ratio) : Json(nullptr)},
          {"worst_time_s", run ? number(verification.velocity_time) : Json(nullptr)},
          {"worst_joint", joint_name(problem, verification.velocity_joint)},
          {"slowest", number(slowest)},
          {"slowed", std::move(slowed)}};
}

Json counts(const FailureCounts& counts) {
  Json collision = Json::array();
  for (const auto& [pair, count] : counts.collision) {
    collision.push_back({{"pair", names(pair)}, {"postures", count}});
  }
  return {{"samples", counts.samples},         {"out_of_reach", counts.out_of_reach},
          {"joint_limit", counts.joint_limit}, {"collision", std::move(collision)},
          {"usable", counts.usable},           {"too_fast", counts.too_fast},
          {"too_far", counts.too_far},         {"astray", counts.astray},
          {"blocked", counts.blocked}};
}

Json diagnosis(const std::vector<Diagnosis>& diagnosis) {
  Json json = Json::array();
  for (const Diagnosis& entry : diagnosis)
    json.push_back({{"waypoint", entry.waypoint ? Json(*entry.waypoint) : Json(nullptr)},
                    {"reason", entry.reason},
                    {"detail", entry.detail},
                    {"suggestion", entry.suggestion},
                    {"counts", entry.counts ? counts(*entry.counts) : Json(nullptr)}});
  return json;
}

std::vector<std::string> joint_names(const Problem& problem) {
  std::vector<std::string> joints;
  if (!problem.robot) return joints;
  for (const Joint& joint : problem.robot->joints()) joints.push_back(joint.name);
  return joints;
}

Task task_as_run(const PlanResult& result, const Problem& problem) {
  return result.seam_time.empty() ? problem.task : problem.task.retimed(result.seam_time);
}

std::string printed(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

std::string mode_name(Mode mode) {
  switch (mode) {
    case Mode::two_stage:
      return "two-stage";
    case Mode::graph_only:
      return "graph-only";
    case Mode::smooth:
      break;
  }
  return "smooth";
}

std::string status_name(Status status) {
  switch (status) {
    case Status::solved:
      return "solved";
    case Status::infeasible:
      return "infeasible";
    case Status::interrupted:
      return "interrupted";
    case Status::failed:
      break;
  }
  return "failed";
}

std::string verification_json(const Verification& verification, const Problem& problem) {
  return printed(verification_object(verification, problem));
}

std::size_t waypoint_count(const PlanResult& result, const Problem& problem) {
  if (result.mode == Mode::smooth) return result.path.size();
  const auto& waypoints = problem.task.waypoints;
  return static_cast<std::size_t>(
      std::count_if(waypoints.begin(), waypoints.end(),
                    [](const Waypoint& waypoint) { return waypoint.welding; }));
}

std::string result_json(const PlanResult& result, const Problem& problem) {
  Json contacts = Json::array();
  for (const auto& pair : result.permanent_contacts) contacts.push_back(names(pair));
  Json json = {{"status", status_name(result.status)},
               {"mode", mode_name(result.mode)},
               {"waypoints", waypoint_count(result, problem)},
               {"joints", joint_names(problem)},
               {"timing_s", timing(result.timing)},
               {"peak_rss_bytes", peak_rss_bytes()},
               {"graph", graph(result)},
               {"refine", refine(result.refine)},
               {"peaks", peaks(result.path, problem)},
               {"verification", verification_object(result.verification, problem)},
               {"speed_held", speed_held(result, problem)},
               {"diagnosis", diagnosis(result.diagnosis)},
               {"problem", problem.name},
               {"inverse_kinematics", result.inverse_kinematics},
               {"permanent_contacts", std::move(contacts)},
               {"warnings", result.warnings}};
  const Task task = task_as_run(result, problem);
  if (task.rest_at_start) json["run_in_s"] = task.weld_start() - task.seam.start_time();
  if (task.rest_at_end) json["run_out_s"] = task.seam.end_time() - task.weld_end();
  if (result.mode == Mode::smooth) {
    json["before"] = before(result, problem);
    json["after"] = after(result, problem);
  }
  return printed(json);
}

void write_result(const std::filesystem::path& folder, const PlanResult& result,
                  const Problem& problem) {
  const std::filesystem::path points = folder / "trajectory.csv";
  const std::filesystem::path dense = folder / "trajectory_dense.csv";
  std::filesystem::create_directories(folder);
  std::filesystem::remove(points);
  std::filesystem::remove(dense);
  const SeamColumns seam(task_as_run(result, problem));
  if (!result.trajectory.empty()) {
    write_trajectory(points, joint_names(problem), result.trajectory, seam);
    write_dense(dense, joint_names(problem), result.trajectory, problem.controller_period, seam);
  } else if (result.path.size() > 0) {
    write_path(points, joint_names(problem), result.path, seam);
  }
  write_text(folder / "result.json", result_json(result, problem));
}

}  // namespace wristwise
