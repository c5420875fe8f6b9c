#include "graph/graph_search.hpp"

#include <utility>

namespace wristwise {

namespace {

struct SearchTooLong {};

EdgeRules with_limited_checks(EdgeRules rules, std::size_t& left) {
  if (!rules.is_clear) return rules;
  rules.is_clear = [is_clear = std::move(rules.is_clear), &left](int worker, std::size_t interval,
                                                                 const JointVector& from,
                                                                 const JointVector& to) {
    if (left == 0) throw SearchTooLong{};
    --left;
    return is_clear(worker, interval, from, to);
  };
  return rules;
}

}  // namespace

GraphSearch::GraphSearch(const SamplingInput& input, const Task& task, double epsilon, int threads,
                         const Monitor& monitor)
    : moves_(task, input.clearance,
             {input.options.max_stray, input.options.max_tcp_step, input.options.max_tcp_turn},
             epsilon, threads),
      threads_(threads),
      monitor_(monitor) {
  set_costs(input.cost, input.robot.joint_count());
  set_filters(input, task);
}

void GraphSearch::set_costs(const CostOptions& cost, int joints) {
  rules_.weight = JointVector::Constant(joints, cost.joint_motion);
  for (std::size_t j = 0; j < cost.joint_weights.size(); ++j) {
    rules_.weight[static_cast<Eigen::Index>(j)] *= cost.joint_weights[j];
  }
  rules_.squared = cost.squared_steps;
  rules_.vertex_cost = cost.vertex_cost;
  rules_.edge_cost = cost.edge_cost;
}

void GraphSearch::set_filters(const SamplingInput& input, const Task& task) {
  rules_.period = turn_periods(input.robot, input.options.turns);
  rules_.lower = input.robot.lower_limits();
  rules_.upper = input.robot.upper_limits();
  for (std::size_t i = 0; i + 1 < task.waypoints.size(); ++i) {
    rules_.max_step.push_back((task.waypoints[i + 1].time - task.waypoints[i].time) *
                              input.robot.velocity_limits());
  }
  const bool measured = !input.clearance->pairs().empty();
  if (input.options.collision_checks == CollisionChecks::lazy && measured) {
    rules_.is_usable = [this](int worker, std::size_t rung, const JointVector& q) {
      return moves_.has_clearance(worker, rung, q);
    };
  }
  if (moves_.limits().steps()) {
    rules_.is_near = [this](std::size_t, const JointVector& from, const JointVector& to) {
      return !moves_.steps_too_far(from, to);
    };
  }
  if (!input.options.check_moves || (!measured && !moves_.limits().strays())) return;
  rules_.is_clear = [this](int worker, std::size_t interval, const JointVector& from,
                           const JointVector& to) {
    return moves_.is_clear(worker, interval, from, to);
  };
}

void GraphSearch::check_moves_only_in(std::vector<bool> intervals) {
  if (rules_.is_near) {
    rules_.is_near = [is_near = rules_.is_near, intervals](
                         std::size_t interval, const JointVector& from, const JointVector& to) {
      return !intervals[interval] || is_near(interval, from, to);
    };
  }
  if (rules_.is_clear) {
    rules_.is_clear = [is_clear = rules_.is_clear, intervals = std::move(intervals)](
                          int worker, std::size_t interval, const JointVector& from,
                          const JointVector& to) {
      return !intervals[interval] || is_clear(worker, interval, from, to);
    };
  }
}

void GraphSearch::slow_down(double factor) {
  for (JointVector& step : rules_.max_step) step *= factor;
}

LadderPath GraphSearch::find_path(const std::vector<Rung>& rungs) {
  return find_least_cost_path(rungs, rules_, threads_, monitor_);
}

LadderPath GraphSearch::find_path(const std::vector<Rung>& rungs, KnownChecks& known) {
  return find_least_cost_path(rungs, rules_, threads_, monitor_, &known);
}

std::optional<LadderPath> GraphSearch::find_path_within(std::size_t& left,
                                                        const std::vector<Rung>& rungs,
                                                        KnownChecks& known) {
  try {
    return find_least_cost_path(rungs, with_limited_checks(rules_, left), 1, monitor_, &known);
  } catch (const SearchTooLong&) {
    return std::nullopt;
  }
}

}  // namespace wristwise
