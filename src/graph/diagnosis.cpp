#include "graph/diagnosis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "graph/turn_copies.hpp"
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

FailureCounts failure_counts(const Robot& robot, const SampleCounts& counts) {
  FailureCounts result;
  result.samples = counts.samples;
  result.out_of_reach = counts.out_of_reach;
  result.collision = counts.collision;
  for (const auto& [joint, count] : counts.joint_limit) {
    result.joint_limit[joint_name(robot, joint)] = count;
  }
  return result;
}

std::string tally(const FailureCounts& counts) {
  return fmt::format(
      "of {} samples {} are out of reach; {} branches break a joint limit, {} collide",
      counts.samples, counts.out_of_reach, total(counts.joint_limit), total(counts.collision));
}

Diagnosis diagnose_waypoint(const Task& task, std::size_t waypoint, FailureCounts counts) {
  Diagnosis diagnosis;
  diagnosis.waypoint = waypoint;
  const std::string where =
      fmt::format("waypoint {} ({:.4g} s): ", waypoint, task.waypoints[waypoint].time);
  const std::string widen =
      task.waypoints[waypoint].joints ? "widen the ranges of its joints" : "widen the tolerance";
  if (!counts.collision.empty()) {
    const auto& [pair, count] = *most_frequent(counts.collision);
    diagnosis.reason = "collision";
    diagnosis.detail =
        fmt::format("{}every reachable posture is nearer than the clearance, most often {} - {}",
                    where, pair.first, pair.second);
    diagnosis.suggestion = "move the part, or " + widen;
  } else if (!counts.joint_limit.empty()) {
    diagnosis.reason = "joint_limit";
    diagnosis.detail = fmt::format("{}every branch breaks a joint limit, most often that of {}",
                                   where, most_frequent(counts.joint_limit)->first);
    diagnosis.suggestion = "move the part, or " + widen;
  } else {
    diagnosis.reason = "out_of_reach";
    diagnosis.detail = fmt::format("{}out of reach at every sample", where);
    diagnosis.suggestion = "move the part nearer to the robot, or widen the tolerance";
  }
  diagnosis.detail += fmt::format(" ({})", tally(counts));
  diagnosis.counts = std::move(counts);
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

/// Why the moves from the last posture reached to the usable ones of the next waypoint fail.
void count_moves(const SamplingInput& input, const GraphSearch& graph, std::size_t interval,
                 const JointVector& from, const Rung& next, double epsilon, FailureCounts& counts) {
  ClearanceChecker checker(input.clearance);
  counts.usable = static_cast<std::size_t>(next.size());
  for (Eigen::Index v = 0; v < next.size(); ++v) {
    const JointVector to = next.vertex(v);
    if (((to - from).cwiseAbs().array() > graph.rules().max_step[interval].array()).any()) {
      ++counts.too_fast;
    } else if (graph.moves().steps_too_far(from, to)) {
      ++counts.too_far;
    } else if (graph.moves().stray(interval, from, to) > graph.moves().limits().stray) {
      ++counts.astray;
    } else if (!check_motion(checker, StraightMove(from, to), input.clearance->clearance(), epsilon)
                    .clear) {
      ++counts.blocked;
    }
  }
}

/// The pair that blocks the nearest move that is fast enough; nullopt where that is clear.
std::optional<ClearanceModel::Names> blocking_pair(const SamplingInput& input,
                                                   const JointVector& from, const JointVector& to,
                                                   double epsilon) {
  ClearanceChecker checker(input.clearance);
  const SweptClearance swept =
      check_motion(checker, StraightMove(from, to), input.clearance->clearance(), epsilon);
  if (swept.clear) return std::nullopt;
  return input.clearance->names(swept.pair);
}

}  // namespace

std::optional<Diagnosis> diagnose_samples(const Robot& robot, const Task& task,
                                          const SampledPath& sampled) {
  for (std::size_t i = 0; i < sampled.rungs.size(); ++i) {
    if (sampled.rungs[i].size() == 0) {
      return diagnose_waypoint(task, i, failure_counts(robot, sampled.counts[i]));
    }
  }
  return std::nullopt;
}

Diagnosis diagnose_search(const SamplingInput& input, const Task& task, const GraphSearch& graph,
                          const LadderPath& path, double clearance_epsilon) {
  const std::size_t failing = path.positions.size();
  SampleCounts samples;
  const Rung usable = sample_waypoint(input, task.waypoints[failing], samples);
  FailureCounts counts = failure_counts(input.robot, samples);
  if (usable.size() == 0 || failing == 0) return diagnose_waypoint(task, failing, counts);

  const EdgeRules& rules = graph.rules();
  const Rung next = expand_turns({usable}, rules).rungs.front();
  const std::size_t last = failing - 1;
  const JointVector from = path.positions.back();
  count_moves(input, graph, last, from, next, clearance_epsilon, counts);

  Diagnosis diagnosis;
  diagnosis.waypoint = failing;
  diagnosis.detail = fmt::format("waypoint {} ({:.4g} s): ", failing, task.waypoints[failing].time);
  const Eigen::Index nearest = nearest_in_time(next, from, rules, last);
  if (nearest < 0) {
    const auto [joint, ratio] = slowest_joint(next, from, rules.max_step[last]);
    diagnosis.reason = "no_edge";
    diagnosis.detail += fmt::format(
        "no posture can be reached in time from waypoint {}; the least demanding one needs {:.3g} "
        "times the speed of {}",
        last, ratio, joint_name(input.robot, joint));
    diagnosis.suggestion = "weld slower, sample finer, or widen the tolerance";
  } else if (counts.too_far + counts.too_fast == counts.usable) {
    diagnosis.reason = "no_edge";
    diagnosis.detail += fmt::format(
        "from waypoint {} no posture is within graph.max_tcp_step and graph.max_tcp_turn", last);
    diagnosis.suggestion = "raise graph.max_tcp_step or max_tcp_turn, or use more waypoints";
  } else if (const auto pair =
                 blocking_pair(input, from, next.vertex(nearest), clearance_epsilon)) {
    diagnosis.reason = "collision";
    diagnosis.detail +=
        fmt::format("every move from waypoint {} is blocked, the nearest by {} - {}", last,
                    pair->first, pair->second);
    diagnosis.suggestion = "widen the tolerance so that the torch can pass, or move the obstacle";
  } else {
    diagnosis.reason = "no_edge";
    diagnosis.detail += fmt::format(
        "every move from waypoint {} is blocked or swings the TCP off the seam, the nearest by "
        "{:.1f} mm",
        last, 1e3 * graph.moves().stray(last, from, next.vertex(nearest)));
    diagnosis.suggestion = "sample finer, use more waypoints, or raise graph.max_stray";
  }
  diagnosis.detail += fmt::format(
      " ({}; of {} usable postures, seen from the best one before, {} are too fast to reach, {} "
      "too "
      "far, {} astray, {} behind an obstacle)",
      tally(counts), counts.usable, counts.too_fast, counts.too_far, counts.astray, counts.blocked);
  diagnosis.counts = std::move(counts);
  return diagnosis;
}

}  // namespace wristwise
