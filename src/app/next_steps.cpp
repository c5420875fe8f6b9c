#include "app/next_steps.hpp"

#include <fmt/format.h>

#include <map>
#include <vector>

namespace wristwise::app {

namespace {

/// Keys of the problem file and commands, by the reason of the diagnosis.
const std::map<std::string, std::string> kRemedies = {
    {"out_of_reach",
     "move the seam (path.frame), widen path.tolerance, or give a region under placement: and run "
     "wristwise place {}"},
    {"joint_limit",
     "widen path.tolerance, sample it finer (graph.samples), or give a region under placement: and "
     "run wristwise place {}"},
    {"collision",
     "widen path.tolerance so that the torch can lean away, sample it finer (graph.samples), or "
     "lower scene.clearance"},
    {"no_edge", "sample finer (graph.samples), widen path.tolerance, or lower path.speed"},
    {"infeasible_at_this_speed",
     "path.speed_policy: slow (slower only where it must be), or lower path.speed"},
    {"refinement",
     "more starts (graph.seeds: 3), more room (path.tolerance), or a shorter "
     "refine.smoothing_time"},
};

std::string remedy(const PlanResult& result, const RunFiles& files) {
  if (files.problem.empty()) return "a wider --keep, or a shorter --smoothing-time";
  for (const Diagnosis& entry : result.diagnosis) {
    const auto found = kRemedies.find(entry.reason);
    if (found != kRemedies.end())
      return fmt::format(fmt::runtime(found->second), files.problem.string());
  }
  return "look at the failures above; widen that tolerance or lower path.speed";
}

std::string kept(const PlanResult& result) {
  if (!result.trajectory.empty()) return "the best motion of stage 2 until then, not verified";
  if (result.path.size() > 0) return "the path of stage 1 in trajectory.csv, not refined";
  return "result.json alone: no path had been found yet";
}

std::vector<std::string> steps(const PlanResult& result, const RunFiles& files) {
  std::vector<std::string> lines;
  if (files.report)
    lines.push_back("open " + (files.folder / "report.html").string() + " in a browser");
  switch (result.status) {
    case Status::solved:
      if (result.mode == Mode::graph_only)
        lines.emplace_back("smooth it: the same command without --mode graph-only");
      break;
    case Status::interrupted:
      lines.emplace_back(
          "to be done sooner: refine.time_limit in the problem, or coarser graph.samples");
      break;
    case Status::infeasible:
    case Status::failed:
      lines.push_back(remedy(result, files));
  }
  return lines;
}

}  // namespace

std::string next_steps(const PlanResult& result, const RunFiles& files, const Paint& paint) {
  std::string text = "written to " + files.folder.string() + "\n";
  if (result.status == Status::interrupted)
    text += paint.warning("kept:") + " " + kept(result) + "\n";
  for (const std::string& line : steps(result, files))
    text += paint.bold("next:") + " " + line + "\n";
  return text;
}

}  // namespace wristwise::app
