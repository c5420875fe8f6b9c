#include "graph/diagnosis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "wristwise/swept_clearance.hpp"

namespace wristwise {

namespace {

/// The key with the largest count.
template <class Map>
auto most_frequent(const Map& counts) {
  return std::max_element(counts.begin(), counts.end(),
                          [](const auto& a, const auto& b) { return a.second < b.second; });
}

template <class Map>
std::size_t total(const Map& counts) {
  return std::accumulate(counts.begin(), counts.end(), std::size_t{0},
                         [](std::size_t sum, const auto& entry) { return sum + entry.second; });
}

std::string joint_name(const Robot& robot, int joint) {
  return robot.joints()[static_cast<std::size_t>(joint)].name;
}

Diagnosis diagnose_waypoint(const Robot& robot, const Task& task, std::size_t waypoint,
                            const SampleCounts& counts) {
  Diagnosis diagnosis;
  diagnosis.waypoint = waypoint;
  const std::string where =
      fmt::format("waypoint {} ({:.4g} s): ", waypoint, task.waypoints[waypoint].time);
  const std::string widen =
      task.waypoints[waypoint].joints ? "widen the ranges of its joints" : "widen the tolerance";
  const std::string tally = fmt::format(
      " (of {} samples {} are out of reach; {} branches break a joint limit, {} collide)",
      counts.samples, counts.out_of_reach, total(counts.joint_limit), total(counts.collision));
  if (!counts.collision.empty()) {
    const auto& [pair, count] = *most_frequent(counts.collision);
    diagnosis.reason = "collision";
    diagnosis.detail = fmt::format(
        "{}every reachable posture is nearer than the clearance, most "
        "often {} - {}{}",
        where, pair.first, pair.second, tally);
    diagnosis.suggestion = widen + ", sample finer, lower scene.clearance, or move the part";
  } else if (!counts.joint_limit.empty()) {
    const auto& [joint, count] = *most_frequent(counts.joint_limit);
    diagnosis.reason = "joint_limit";
    diagnosis.detail = fmt::format("{}every branch breaks a joint limit, most often that of {}{}",
                                   where, joint_name(robot, joint), tally);
    diagnosis.suggestion = "move the part, or " + widen;
  } else {
    diagnosis.reason = "out_of_reach";
    diagnosis.detail = fmt::format("{}out of reach at every sample{}", where, tally);
    diagnosis.suggestion = "move the part nearer to the robot, or widen the tolerance";
  }
  return diagnosis;
}

/// The vertex of the next rung that is nearest to `from` among those that can be reached in time;
/// -1 if there is none.
Eigen::Index nearest_in_time(const Rung& next, const JointVector& from, const EdgeRules& rules,
                             std::size_t interval) {
  Eigen::Index nearest = -1;
  double least = std::numeric_limits<double>::infinity();
  for (Eigen::Index v = 0; v < next.size(); ++v) {
    const JointVector step = (next.vertex(v) - from).cwiseAbs();
    if ((step.array() > rules.max_step[interval].array()).any()) continue;
    if (step.dot(rules.weight) >= least) continue;
    least = step.dot(rules.weight);
    nearest = v;
  }
  return nearest;
}

/// The joint that needs the largest share of its step limit for the least such move.
std::pair<int, double> slowest_joint(const Rung& next, const JointVector& from,
                                     const JointVector& max_step) {
  std::pair<int, double> worst{0, std::numeric_limits<double>::infinity()};
  for (Eigen::Index v = 0; v < next.size(); ++v) {
    const JointVector share = (next.vertex(v) - from).cwiseAbs().cwiseQuotient(max_step);
    int joint = 0;
    const double ratio = share.maxCoeff(&joint);
    if (ratio < worst.second) worst = {joint, ratio};
  }
  return worst;
}

}  // namespace

std::optional<Diagnosis> diagnose_samples(const Robot& robot, const Task& task,
                                          const SampledPath& sampled) {
  for (std::size_t i = 0; i < sampled.rungs.size(); ++i) {
    if (sampled.rungs[i].size() == 0) {
      return diagnose_waypoint(robot, task, i, sampled.counts[i]);
    }
  }
  return std::nullopt;
}

Diagnosis diagnose_moves(const Task& task, const SampledPath& sampled, const EdgeRules& rules,
                         const LadderPath& path, const MoveChecker& moves,
                         const std::shared_ptr<const ClearanceModel>& clearance,
                         double clearance_epsilon) {
  const std::size_t last = path.vertices.size() - 1;
  const JointVector from = sampled.rungs[last].vertex(path.vertices.back());
  const Rung& next = sampled.rungs[last + 1];
  const Eigen::Index nearest = nearest_in_time(next, from, rules, last);
  Diagnosis diagnosis;
  diagnosis.waypoint = last + 1;
  diagnosis.detail =
      fmt::format("waypoint {} ({:.4g} s): ", last + 1, task.waypoints[last + 1].time);
  if (nearest < 0) {
    const auto [joint, ratio] = slowest_joint(next, from, rules.max_step[last]);
    diagnosis.reason = "no_edge";
    diagnosis.detail += fmt::format(
        "no posture can be reached in time from waypoint {}; the least demanding one needs {:.2f} "
        "times the speed of {}",
        last, ratio, joint_name(clearance->robot(), joint));
    diagnosis.suggestion = "weld slower, sample finer, or widen the tolerance";
    return diagnosis;
  }
  ClearanceChecker checker(clearance);
  const SweptClearance swept = check_motion(checker, StraightMove(from, next.vertex(nearest)),
                                            clearance->clearance(), clearance_epsilon);
  if (!swept.clear) {
    const auto names = clearance->names(swept.pair);
    diagnosis.reason = "collision";
    diagnosis.detail +=
        fmt::format("every move from waypoint {} is blocked, the nearest by {} - {}", last,
                    names.first, names.second);
    diagnosis.suggestion =
        "widen the tolerance so that the torch can pass, lower scene.clearance, "
        "or move the obstacle";
    return diagnosis;
  }
  diagnosis.reason = "no_edge";
  diagnosis.detail += fmt::format(
      "every move from waypoint {} is blocked or swings the TCP off the seam, the nearest by "
      "{:.1f} mm",
      last, 1e3 * moves.stray(last, from, next.vertex(nearest)));
  diagnosis.suggestion = "sample finer, use more waypoints, or raise graph.max_stray";
  return diagnosis;
}

}  // namespace wristwise
