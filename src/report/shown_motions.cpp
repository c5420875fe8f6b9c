#include "report/shown_motions.hpp"

#include "io/result_file.hpp"
#include "verify/row_waypoints.hpp"

namespace wristwise {

namespace {

void add(const std::string& name, const Task& task, const Trajectory& trajectory,
         const JointPath& path, const Verification* verification,
         std::vector<ShownMotion>& motions) {
  if (path.size() == 0 || task.waypoints.empty()) return;
  motions.push_back({name, path.size() > 1 ? row_waypoints(task, path.times).task : task,
                     task.weld_start(), task.weld_end(), trajectory, path, verification});
}

void add(const std::string& name, const PlanResult& result, const Problem& problem,
         std::vector<ShownMotion>& motions) {
  add(name, task_as_run(result, problem), result.trajectory,
      result.trajectory.empty() ? result.path : result.trajectory.waypoints(), &result.verification,
      motions);
}

}  // namespace

std::vector<ShownMotion> shown_motions(const Problem& problem, const PlanResult& result,
                                       const PlanResult* graph_only) {
  std::vector<ShownMotion> motions;
  add(result.mode == Mode::smooth ? "smoothed" : mode_name(result.mode), result, problem, motions);
  if (graph_only != nullptr) {
    add("graph-only", *graph_only, problem, motions);
  } else if (result.before) {
    add("as given", problem.task, {}, result.before->path, &result.before->verification, motions);
  } else if (result.mode == Mode::two_stage && !result.trajectory.empty() &&
             !result.seeds.empty()) {
    add("graph-only", problem.task, {}, result.seeds.front().path, nullptr, motions);
  }
  return motions;
}

std::unique_ptr<CheckedMotion> checked_motion(const ShownMotion& motion) {
  if (motion.trajectory.empty()) return std::make_unique<PointMotion>(motion.path);
  return std::make_unique<CurveMotion>(motion.trajectory);
}

}  // namespace wristwise
