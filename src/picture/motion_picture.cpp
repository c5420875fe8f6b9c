#include "picture/motion_picture.hpp"

#include <algorithm>

#include "io/result_file.hpp"
#include "io/text_file.hpp"
#include "picture/joint_positions_picture.hpp"
#include "picture/joint_profiles_picture.hpp"
#include "picture/tolerance_picture.hpp"

namespace wristwise {

namespace {

constexpr double kTimeTolerance = 1e-6;  // s

std::string title_of(const Problem& problem, const PlanResult& result, const PlotRange& time) {
  std::string title = problem.name + ": " + status_name(result.status);
  if (result.path.times.back() < time.to - kTimeTolerance) title += ", a part of the way only";
  return title;
}

PlotRange time_of(const Problem& problem, const std::vector<ShownMotion>& motions) {
  PlotRange time{problem.task.waypoints.front().time, problem.task.waypoints.back().time};
  for (const ShownMotion& motion : motions) {
    time.from = std::min(time.from, motion.path.times.front());
    time.to = std::max(time.to, motion.path.times.back());
  }
  return time;
}

/// Before and after the weld.
std::vector<PlotRange> runs_of(const ShownMotion& motion, const PlotRange& time) {
  std::vector<PlotRange> runs;
  if (motion.weld_start > time.from + kTimeTolerance)
    runs.push_back({time.from, motion.weld_start});
  if (motion.weld_end < time.to - kTimeTolerance) runs.push_back({motion.weld_end, time.to});
  return runs;
}

}  // namespace

std::vector<std::string> write_motion_pictures(const std::filesystem::path& folder,
                                               const Problem& problem, const PlanResult& result,
                                               const PlanResult* graph_only) {
  std::vector<std::string> names = {"joints.svg", "joint_positions.svg", "tolerance.svg"};
  std::error_code ignored;
  for (const std::string& name : names) std::filesystem::remove(folder / name, ignored);
  if (!problem.robot || result.path.size() == 0 || problem.task.waypoints.empty()) return {};
  std::vector<ShownMotion> motions = shown_motions(problem, result, graph_only);
  const PlotRange time = time_of(problem, motions);
  const std::vector<PlotRange> runs = runs_of(motions.front(), time);
  const MotionPicture picture{title_of(problem, result, time), *problem.robot, std::move(motions),
                              time, runs};
  write_text(folder / names[0], joint_profiles_svg(picture));
  write_text(folder / names[1], joint_positions_svg(picture));
  write_text(folder / names[2], tolerance_svg(picture));
  return names;
}

}  // namespace wristwise
