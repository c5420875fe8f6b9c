#include "app/placement_summary.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>

#include "app/joint_unit.hpp"
#include "app/status_text.hpp"
#include "app/text_table.hpp"
#include "io/frame_keys.hpp"
#include "io/peaks.hpp"
#include "io/result_file.hpp"

namespace wristwise::app {

namespace {

constexpr double kDegree = 0.017453292519943295;

bool is_found(const PlacementResult& result) {
  return result.after.placed.problem.robot != nullptr;
}

std::string headline(const PlacementRequest& request, const PlacementResult& result,
                     const Paint& paint) {
  const std::string what = request.options.placed == Placed::part ? "part" : "robot";
  const std::string with = request.options.with.empty()
                               ? ""
                               : fmt::format(" with {}", fmt::join(request.options.with, ", "));
  return fmt::format("{}: {} (placement of the {}{}; {} placements measured, {:.1f} s)\n",
                     paint.bold(request.problem.name), status_text(result.status, paint), what,
                     with, result.evaluations, result.seconds);
}

std::string stopped_line(const PlacementResult& result) {
  return result.out_of_time ? "  stopped by placement.time_limit: the best until then, and what "
                              "there is of the map\n"
                            : "";
}

std::string offset_text(int coordinate, double value) {
  return coordinate < 3 ? fmt::format("{} m", short_number(value))
                        : fmt::format("{} deg", short_number(value / kDegree));
}

std::string checked(const PlanResult& plan, const Paint& paint) {
  return plan.verification.passed ? paint.good("passed") : status_text(plan.status, paint);
}

TableRow measure_row(const std::string& name, const PlacementResult& result,
                     const std::function<std::string(const PlacementMeasure&)>& text) {
  const auto cell = [&](const PlacementMeasure& measure) {
    return measure.feasible ? text(measure) : "-";
  };
  return {name, cell(result.given.measure), cell(result.found.measure)};
}

std::string peak_text(const PlanResult& plan, int joint) {
  const auto peak = peak_derivative(plan.path, 1);
  if (!peak || !plan.verification.run) return "-";
  return short_number((*peak)[joint]);
}

std::string measure_table(const PlacementResult& result, const Paint& paint) {
  std::vector<TableRow> rows = {{"", "given", "found"}};
  for (int i = 0; i < 6; ++i) {
    if (result.found.offset[i] == 0) continue;
    rows.push_back({std::string("moved by ") + kCoordinateNames[static_cast<std::size_t>(i)], "0",
                    offset_text(i, result.found.offset[i])});
  }
  rows.push_back(
      {"check", checked(result.before.two_stage, paint), checked(result.after.two_stage, paint)});
  rows.push_back(measure_row("measure", result,
                             [](const PlacementMeasure& m) { return short_number(m.value); }));
  rows.push_back(measure_row("joint speed / limit", result, [](const PlacementMeasure& m) {
    return short_number(m.speed_ratio);
  }));
  rows.push_back(
      measure_row("distance from singularity, 0 to 1", result,
                  [](const PlacementMeasure& m) { return short_number(m.singularity_distance); }));
  rows.push_back(
      measure_row("clearance, without the tool at the part", result, [](const PlacementMeasure& m) {
        return m.clearance ? short_number(*m.clearance) + " m" : "-";
      }));
  return aligned(rows, 0);
}

std::string peak_table(const PlacementPlans& before, const PlacementPlans& after,
                       const Paint& paint) {
  std::vector<TableRow> rows = {
      {paint.bold("peak velocity"), "given", "given", "found", "found", ""},
      {"", "graph-only", "two-stage", "graph-only", "two-stage", ""}};
  const Robot& robot = *before.placed.problem.robot;
  for (int j = 0; j < robot.joint_count(); ++j) {
    const Joint& joint = robot.joints()[static_cast<std::size_t>(j)];
    TableRow row = {joint.name};
    for (const PlanResult* plan :
         {&before.graph_only, &before.two_stage, &after.graph_only, &after.two_stage})
      row.push_back(peak_text(*plan, j));
    row.push_back(joint_unit(joint) + "/s");
    rows.push_back(std::move(row));
  }
  return aligned(rows, 0);
}

std::string lines_to_paste(const PlacedProblem& placed, const Paint& paint) {
  std::string text = paint.bold("to put into the problem file") +
                     "\n  path.frame: " + frame_text(placed.part_frame) + "\n";
  for (const SceneObject& object : placed.problem.scene.objects) {
    const bool moved =
        std::find(placed.moved.begin(), placed.moved.end(), object.name) != placed.moved.end();
    if (moved)
      text +=
          "  scene.objects, " + object.name + ": " + frame_text(object.shapes.front().pose) + "\n";
  }
  return text;
}

std::string written(const PlacementResult& result, const std::filesystem::path& folder) {
  std::string files = "placement.json";
  if (!result.map.axes.empty()) files += ", map.csv, map.svg";
  if (is_found(result)) files += ", problem_placed.yaml, plan/";
  return "written to " + folder.string() + ": " + files + "\n";
}

}  // namespace

std::string placement_summary(const PlacementRequest& request, const PlacementResult& result,
                              const std::filesystem::path& folder, const Paint& paint) {
  std::string text = headline(request, result, paint) + diagnosis_text(result.diagnosis, paint) +
                     stopped_line(result);
  if (is_found(result))
    text += measure_table(result, paint) + peak_table(result.before, result.after, paint) +
            lines_to_paste(result.after.placed, paint);
  return text + written(result, folder);
}

}  // namespace wristwise::app
