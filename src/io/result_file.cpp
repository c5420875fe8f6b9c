#include "io/result_file.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "io/json_diagnosis.hpp"
#include "io/json_graph.hpp"
#include "io/json_peaks.hpp"
#include "io/json_refine.hpp"
#include "io/json_speed.hpp"
#include "io/json_verification.hpp"
#include "io/text_file.hpp"
#include "wristwise/trajectory_file.hpp"

namespace wristwise {

namespace {

using json::Json;

Json peak_rss_bytes() {
  rusage usage{};
  if (getrusage(RUSAGE_SELF, &usage) != 0) return nullptr;
  return static_cast<std::int64_t>(usage.ru_maxrss) * 1024;
}

Json timing(const Timing& timing) {
  return {{"load", json::number(timing.load)},     {"sampling", json::number(timing.sampling)},
          {"search", json::number(timing.search)}, {"refine", json::number(timing.refine)},
          {"verify", json::number(timing.verify)}, {"total", json::number(timing.total)}};
}

/// None where the run ended before there was a robot.
std::vector<std::string> joint_names(const Problem& problem) {
  return problem.robot ? problem.robot->joint_names() : std::vector<std::string>();
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

Task task_as_run(const PlanResult& result, const Problem& problem) {
  return result.seam_time.empty() ? problem.task : problem.task.retimed(result.seam_time);
}

std::string verification_json(const Verification& verification, const Problem& problem) {
  return printed(json::verification(verification, problem));
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
  for (const auto& pair : result.permanent_contacts) contacts.push_back(json::names(pair));
  Json object = {{"status", status_name(result.status)},
                 {"mode", mode_name(result.mode)},
                 {"waypoints", waypoint_count(result, problem)},
                 {"joints", joint_names(problem)},
                 {"timing_s", timing(result.timing)},
                 {"peak_rss_bytes", peak_rss_bytes()},
                 {"graph", json::graph(result)},
                 {"refine", json::refine(result.refine)},
                 {"peaks", json::peaks(result.path, problem)},
                 {"verification", json::verification(result.verification, problem)},
                 {"speed_held", json::speed_held(result, problem)},
                 {"diagnosis", json::diagnosis(result.diagnosis)},
                 {"problem", problem.name},
                 {"inverse_kinematics", result.inverse_kinematics},
                 {"permanent_contacts", std::move(contacts)},
                 {"warnings", result.warnings}};
  const Task task = task_as_run(result, problem);
  if (task.rest_at_start) object["run_in_s"] = task.weld_start() - task.seam.start_time();
  if (task.rest_at_end) object["run_out_s"] = task.seam.end_time() - task.weld_end();
  if (result.mode == Mode::smooth) {
    object["before"] = json::before(result, problem);
    object["after"] = json::after(result, problem);
  }
  return printed(object);
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
