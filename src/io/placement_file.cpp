#include "io/placement_file.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "io/frame_keys.hpp"
#include "io/json_diagnosis.hpp"
#include "io/json_value.hpp"
#include "io/peaks.hpp"
#include "io/placed_problem_file.hpp"
#include "io/result_file.hpp"
#include "io/text_file.hpp"
#include "picture/placement_map_picture.hpp"

namespace wristwise {

namespace {

using json::coordinates;
using json::Json;
using json::number;

Json vector(const Eigen::Vector3d& values) {
  return Json::array({values.x(), values.y(), values.z()});
}

Json frame(const Pose& pose) {
  const FrameKeys keys = frame_keys(pose);
  return {{"xyz", vector(keys.xyz)}, {"rpy", vector(keys.rpy)}};
}

Json measure(const PlacementMeasure& measure) {
  const bool measured = measure.singularity_distance > 0 || measure.speed_ratio > 0;
  return {{"feasible", measure.feasible},
          {"value", number(measure.value)},
          {"obstacle", measure.feasible ? Json(nullptr) : Json(measure.obstacle)},
          {"waypoints_share", number(measure.waypoints_share)},
          {"speed_ratio", measured ? number(measure.speed_ratio) : Json(nullptr)},
          {"singularity_distance", measured ? number(measure.singularity_distance) : Json(nullptr)},
          {"clearance_m", number(measure.clearance)}};
}

/// Peak joint velocities, as in result.json.
Json peak_velocities(const PlanResult& plan, const Robot& robot) {
  Json peaks = Json::object();
  const auto peak = peak_derivative(plan.path, 1);
  for (int j = 0; j < robot.joint_count(); ++j)
    peaks[robot.joints()[static_cast<std::size_t>(j)].name] =
        peak ? number((*peak)[j]) : Json(nullptr);
  return peaks;
}

Json plans(const PlacementPlans& plans, const Placement& placement) {
  const Problem& problem = plans.placed.problem;
  Json objects = Json::object();
  for (const SceneObject& object : problem.scene.objects)
    objects[object.name] = frame(object.shapes.front().pose);
  return {{"offset", coordinates(placement.offset)},
          {"frame", frame(plans.placed.part_frame)},
          {"moved_objects", plans.placed.moved},
          {"objects", std::move(objects)},
          {"measure", measure(placement.measure)},
          {"status",
           {{"graph-only", status_name(plans.graph_only.status)},
            {"two-stage", status_name(plans.two_stage.status)}}},
          {"passed", plans.two_stage.verification.passed},
          {"peak_velocity",
           {{"graph-only", peak_velocities(plans.graph_only, *problem.robot)},
            {"two-stage", peak_velocities(plans.two_stage, *problem.robot)}}}};
}

Json region(const PlacementOptions& options) {
  Json ranges = Json::object();
  for (int i = 0; i < 6; ++i)
    ranges[kCoordinateNames[static_cast<std::size_t>(i)]] =
        Json::array({number(options.lower[i]), number(options.upper[i])});
  return ranges;
}

void write_or_remove(const std::filesystem::path& file, const std::string& text) {
  if (text.empty())
    std::filesystem::remove(file);
  else
    write_text(file, text);
}

bool is_found(const PlacementResult& result) {
  return result.after.placed.problem.robot != nullptr;
}

}  // namespace

std::string placement_json(const PlacementRequest& request, const PlacementResult& result) {
  const PlacementOptions& options = request.options;
  Json obstacles = Json::object();
  for (const auto& [reason, count] : result.obstacles)
    obstacles[reason.empty() ? "none" : reason] = count;
  const bool has_before = result.before.placed.problem.robot != nullptr;
  Json all = {{"status", status_name(result.status)},
              {"problem", request.problem.name},
              {"move", options.placed == Placed::part ? "part" : "robot"},
              {"with", options.with},
              {"region", region(options)},
              {"seed", options.seed},
              {"evaluations", result.evaluations},
              {"obstacles", std::move(obstacles)},
              {"out_of_time", result.out_of_time},
              {"time_s", number(result.seconds)},
              {"given", has_before ? plans(result.before, result.given) : Json(nullptr)},
              {"found", is_found(result) ? plans(result.after, result.found) : Json(nullptr)},
              {"diagnosis", json::diagnosis(result.diagnosis)}};
  if (!is_found(result) && result.status == Status::infeasible)
    all["nearest"] = {{"offset", coordinates(result.found.offset)},
                      {"measure", measure(result.found.measure)}};
  return all.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string placement_map_csv(const PlacementResult& result) {
  if (result.map.samples.empty()) return {};
  std::string text =
      "x,y,z,rx,ry,rz,measure,feasible,obstacle,waypoints_share,speed_ratio,singularity_distance,"
      "clearance\n";
  for (const auto& [offset, measure] : result.map.samples) {
    for (int i = 0; i < 6; ++i) text += fmt::format("{},", offset[i]);
    text += fmt::format("{},{},{},{},", measure.value, measure.feasible ? 1 : 0, measure.obstacle,
                        measure.waypoints_share);
    if (measure.feasible)
      text += fmt::format("{},{},", measure.speed_ratio, measure.singularity_distance);
    else
      text += ",,";
    if (measure.feasible && measure.clearance) text += fmt::format("{}", *measure.clearance);
    text += "\n";
  }
  return text;
}

void write_placement(const std::filesystem::path& folder, const PlacementRequest& request,
                     const PlacementResult& result, const std::filesystem::path& problem_file) {
  std::filesystem::create_directories(folder);
  write_or_remove(folder / "map.csv", placement_map_csv(result));
  write_or_remove(
      folder / "map.svg",
      placement_map_svg(result, request.problem.name + (request.options.placed == Placed::part
                                                            ? ": where the part can stand"
                                                            : ": where the robot can stand")));
  std::filesystem::remove(folder / "problem_placed.yaml");
  std::filesystem::remove_all(folder / "plan");
  if (is_found(result)) {
    write_text(folder / "problem_placed.yaml",
               placed_problem_text(problem_file, result.after.placed, folder));
    write_result(folder / "plan", result.after.two_stage, result.after.placed.problem);
  }
  write_text(folder / "placement.json", placement_json(request, result));
}

}  // namespace wristwise
