#include "app/summary.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/smoothing_table.hpp"
#include "app/text_table.hpp"
#include "app/verification_table.hpp"
#include "io/peaks.hpp"
#include "io/result_file.hpp"

namespace wristwise::app {

namespace {

/// m, without run-in and run-out.
double weld_length(const Task& task) {
  const double start = task.seam.nominal_time(task.weld_start());
  const double end = task.seam.nominal_time(task.weld_end());
  double length = 0;
  for (const SeamPiece& piece : task.seam.pieces()) {
    const double middle = 0.5 * (piece.start_time + piece.end_time);
    if (middle > start && middle < end) length += piece.length();
  }
  return length;
}

std::string headline(const PlanResult& result, const Problem& problem) {
  const Task& task = problem.task;
  return fmt::format(
      "{}: {} ({}, {} waypoints, {} m in {} s)\n", problem.name.empty() ? "problem" : problem.name,
      status_name(result.status), mode_name(result.mode), waypoint_count(result, problem),
      short_number(weld_length(task)), short_number(task.weld_end() - task.weld_start()));
}

std::string diagnosis_lines(const PlanResult& result) {
  std::string text;
  for (const Diagnosis& entry : result.diagnosis) {
    if (entry.reason == "verification") continue;  // the table of the check says it
    text += "  " + entry.reason;
    if (entry.waypoint) text += fmt::format(" at waypoint {}", *entry.waypoint);
    text += ": " + entry.detail + "\n";
    if (!entry.suggestion.empty()) text += "    what would help: " + entry.suggestion + "\n";
  }
  return text;
}

std::string refined_text(const Seed& seed) {
  if (seed.objective) return ", refined: " + short_number(*seed.objective);
  return seed.refinement == "not run" ? "" : ", refined: " + seed.refinement;
}

std::string graph_lines(const PlanResult& result) {
  const GraphStatistics& graph = result.graph;
  if (graph.vertices == 0) return {};
  std::vector<TableRow> rows = {
      {"vertices", fmt::format("{}", graph.vertices)},
      {"edges", short_number(graph.edges)},
      {"edges evaluated", short_number(graph.edges_evaluated)},
      {"postures checked", fmt::format("{} of {}", graph.postures_checked, graph.postures)},
      {"moves checked", fmt::format("{}", graph.edges_checked)},
      {"distance queries", fmt::format("{}", graph.collision_checks)},
      {"cost", short_number(graph.cost)},
      {"joint motion (L1)", short_number(graph.joint_motion_l1)},
      {"turns, first and last", fmt::format("{} and {}", fmt::join(graph.first_turns, " "),
                                            fmt::join(graph.last_turns, " "))}};
  if (graph.grid_rounds > 0) {
    rows.push_back(
        {"coarse to fine", fmt::format("cost {} before, {} searches",
                                       short_number(graph.first_cost), graph.grid_rounds)});
  }
  if (graph.sparse_points > 0) {
    rows.push_back({"sparse", fmt::format("{} waypoints planned, {} replans", graph.sparse_points,
                                          graph.replans)});
  }
  for (std::size_t k = 1; k < result.seeds.size(); ++k) {
    rows.push_back(
        {fmt::format("path {}", k + 1),
         fmt::format("cost {}, differs at waypoint {}{}", short_number(result.seeds[k].cost),
                     result.seeds[k].differs_at, refined_text(result.seeds[k]))});
  }
  return "graph\n" + aligned(rows);
}

std::string active_lines(const RefineStatistics& refine) {
  constexpr std::size_t kMost = 5;
  std::string text;
  for (std::size_t i = 0; i < std::min(kMost, refine.active.size()); ++i)
    text += "  " + refine.active[i].sentence + "\n";
  return text.empty() ? text : "what holds it back\n" + text;
}

std::string refine_lines(const PlanResult& result) {
  const RefineStatistics& refine = result.refine;
  if (!refine.run) return {};
  std::string text =
      fmt::format("refinement: {} iterations in {} rounds, {} control points, {}\n",
                  refine.iterations, refine.rounds, refine.control_points, refine.termination);
  std::vector<TableRow> rows = {{"integral of", "before", "after"}};
  double before = 0;
  for (const CostTerm& term : refine.terms) {
    if (term.initial == 0 && term.final == 0) continue;
    rows.push_back({term.name, short_number(term.initial), short_number(term.final)});
    before += term.initial;
  }
  rows.push_back({"sum", short_number(before), short_number(refine.objective)});
  return text + aligned(rows) + active_lines(refine);
}

std::string peak_lines(const PlanResult& result, const Problem& problem) {
  if (!problem.robot || result.path.size() < 2) return {};
  std::vector<TableRow> rows = {{"peaks of", "velocity", "acceleration", "jerk"}};
  for (int j = 0; j < problem.robot->joint_count(); ++j) {
    TableRow row = {problem.robot->joints()[static_cast<std::size_t>(j)].name};
    for (int order = 1; order <= 3; ++order) {
      const auto peak = peak_derivative(result.path, order);
      row.push_back(peak ? short_number((*peak)[j]) : "-");
    }
    rows.push_back(std::move(row));
  }
  return aligned(rows, 0);
}

std::string note_lines(const PlanResult& result, const Problem& problem) {
  std::string text;
  for (const SceneObject& object : problem.scene.objects) {
    if (!object.convex_error) continue;
    text += fmt::format("mesh of {}: {} convex pieces, at most {:.2g} mm beyond it\n", object.name,
                        object.shapes.size(), 1000 * *object.convex_error);
  }
  for (const auto& [first, second] : result.permanent_contacts)
    text += fmt::format("left out, in contact at every posture: {} - {}\n", first, second);
  for (const std::string& warning : result.warnings) text += "warning: " + warning + "\n";
  return text;
}

std::string slowed_lines(const PlanResult& result, const Problem& problem) {
  std::string text;
  for (const SlowedStretch& stretch : result.slowed) {
    text += fmt::format("slowed: {:.4g} to {:.4g} s, down to {:.3g}% of the weld speed, by {}\n",
                        stretch.from, stretch.to, 100 * stretch.least_ratio,
                        problem.robot->joints()[static_cast<std::size_t>(stretch.joint)].name);
  }
  return text;
}

std::string timing_line(const Timing& timing) {
  return fmt::format(
      "time: load {:.3f} s, sampling {:.3f} s, search {:.3f} s, refine {:.3f} s, verify {:.3f} s, "
      "total {:.3f} s\n",
      timing.load, timing.sampling, timing.search, timing.refine, timing.verify, timing.total);
}

}  // namespace

std::string summary(const PlanResult& result, const Problem& problem,
                    const std::filesystem::path& folder) {
  std::string text = headline(result, problem) + diagnosis_lines(result);
  if (!result.inverse_kinematics.empty())
    text += "inverse kinematics: " + result.inverse_kinematics + "\n";
  text += graph_lines(result) + refine_lines(result);
  text += result.before ? smoothing_table(result, problem) : peak_lines(result, problem);
  if (result.verification.run) text += verification_table(result.verification, problem);
  text += slowed_lines(result, problem) + note_lines(result, problem) + timing_line(result.timing);
  return text + "written to " + folder.string() + "\n";
}

}  // namespace wristwise::app
