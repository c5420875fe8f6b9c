#include "app/summary.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/joint_unit.hpp"
#include "app/smoothing_table.hpp"
#include "app/status_text.hpp"
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

std::string headline(const PlanResult& result, const Problem& problem, const Paint& paint) {
  const Task& task = problem.task;
  return fmt::format("{}: {} ({}, {} waypoints, {} m in {} s)\n",
                     paint.bold(problem.name.empty() ? "problem" : problem.name),
                     status_text(result.status, paint), mode_name(result.mode),
                     waypoint_count(result, problem), short_number(weld_length(task)),
                     short_number(task.weld_end() - task.weld_start()));
}

std::string refined_text(const Seed& seed) {
  if (seed.objective) return ", refined: " + short_number(*seed.objective);
  return seed.refinement == "not run" ? "" : ", refined: " + seed.refinement;
}

std::string graph_lines(const PlanResult& result, const Paint& paint) {
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
  return paint.bold("stage 1: graph") + "\n" + aligned(rows, 2, Flush::left);
}

std::string active_lines(const RefineStatistics& refine, const Paint& paint) {
  constexpr std::size_t kMost = 5;
  std::string text;
  for (std::size_t i = 0; i < std::min(kMost, refine.active.size()); ++i)
    text += "  " + refine.active[i].sentence + "\n";
  return text.empty() ? text : paint.bold("what holds it back") + "\n" + text;
}

std::string refine_lines(const PlanResult& result, const Paint& paint) {
  const RefineStatistics& refine = result.refine;
  if (!refine.run) return {};
  std::string text = fmt::format("{} {} iterations in {} rounds, {} control points, {}\n",
                                 paint.bold("stage 2: refinement:"), refine.iterations,
                                 refine.rounds, refine.control_points, refine.termination);
  std::vector<TableRow> rows = {{"integral of", "before", "after"}};
  double before = 0;
  for (const CostTerm& term : refine.terms) {
    if (term.initial == 0 && term.final == 0) continue;
    rows.push_back({term.name, short_number(term.initial), short_number(term.final)});
    before += term.initial;
  }
  rows.push_back({"sum", short_number(before), short_number(refine.objective)});
  return text + aligned(rows) + active_lines(refine, paint);
}

std::string peak_lines(const PlanResult& result, const Problem& problem, const Paint& paint) {
  if (!problem.robot || result.path.size() < 2) return {};
  std::vector<TableRow> rows = {
      {paint.bold("peaks of"), "velocity", "acceleration", "jerk", "unit"}};
  for (int j = 0; j < problem.robot->joint_count(); ++j) {
    const Joint& joint = problem.robot->joints()[static_cast<std::size_t>(j)];
    TableRow row = {joint.name};
    for (int order = 1; order <= 3; ++order) {
      const auto peak = peak_derivative(result.path, order);
      row.push_back(peak ? short_number((*peak)[j]) : "-");
    }
    row.push_back(joint_unit(joint) + ", s");
    rows.push_back(std::move(row));
  }
  return aligned(rows, 0);
}

std::string note_lines(const PlanResult& result, const Problem& problem, const Paint& paint) {
  std::string text;
  for (const SceneObject& object : problem.scene.objects) {
    if (!object.convex_error) continue;
    text += fmt::format("mesh of {}: {} convex pieces, at most {:.2g} mm beyond it\n", object.name,
                        object.shapes.size(), 1000 * *object.convex_error);
  }
  for (const auto& [first, second] : result.permanent_contacts)
    text += fmt::format("left out, in contact at every posture: {} - {}\n", first, second);
  for (const std::string& warning : result.warnings)
    text += paint.warning("warning:") + " " + warning + "\n";
  return text;
}

std::string slowed_lines(const PlanResult& result, const Problem& problem, const Paint& paint) {
  std::string text;
  for (const SlowedStretch& stretch : result.slowed) {
    text +=
        fmt::format("{} {:.4g} to {:.4g} s, down to {:.3g}% of the weld speed, by {}\n",
                    paint.warning("slowed:"), stretch.from, stretch.to, 100 * stretch.least_ratio,
                    problem.robot->joints()[static_cast<std::size_t>(stretch.joint)].name);
  }
  return text;
}

std::string timing_line(const Timing& timing) {
  return fmt::format(
      "time {:.3f} s: load {:.3f}, sampling {:.3f}, search {:.3f}, refine {:.3f}, verify {:.3f}\n",
      timing.total, timing.load, timing.sampling, timing.search, timing.refine, timing.verify);
}

}  // namespace

std::string summary(const PlanResult& result, const Problem& problem, const Paint& paint) {
  std::string text = headline(result, problem, paint) + diagnosis_text(result.diagnosis, paint);
  if (!result.inverse_kinematics.empty())
    text += "inverse kinematics: " + result.inverse_kinematics + "\n";
  text += graph_lines(result, paint) + refine_lines(result, paint);
  text +=
      result.before ? smoothing_table(result, problem, paint) : peak_lines(result, problem, paint);
  if (result.verification.run) text += verification_table(result.verification, problem, paint);
  text += slowed_lines(result, problem, paint) + note_lines(result, problem, paint) +
          timing_line(result.timing);
  return text;
}

}  // namespace wristwise::app
