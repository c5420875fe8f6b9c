#include "graph/graph_search.hpp"

namespace wristwise {

GraphSearch::GraphSearch(const SamplingInput& input, const Task& task, double epsilon, int threads,
                         const Monitor& monitor)
    : input_(input),
      moves_(task, input.clearance,
             {input.options.max_stray, input.options.max_tcp_step, input.options.max_tcp_turn},
             epsilon, threads),
      threads_(threads),
      monitor_(monitor) {
  set_costs();
  set_filters(task);
}

void GraphSearch::set_costs() {
  const CostOptions& cost = input_.cost;
  rules_.weight = JointVector::Constant(input_.robot.joint_count(), cost.joint_motion);
  for (std::size_t j = 0; j < cost.joint_weights.size(); ++j) {
    rules_.weight[static_cast<Eigen::Index>(j)] *= cost.joint_weights[j];
  }
}

void GraphSearch::set_filters(const Task& task) {
  rules_.period = turn_periods(input_.robot, input_.options.turns);
  rules_.lower = input_.robot.lower_limits();
  rules_.upper = input_.robot.upper_limits();
  for (std::size_t i = 0; i + 1 < task.waypoints.size(); ++i) {
    rules_.max_step.push_back((task.waypoints[i + 1].time - task.waypoints[i].time) *
                              input_.robot.velocity_limits());
  }
  if (input_.options.collision_checks == CollisionChecks::lazy &&
      !input_.clearance->pairs().empty()) {
    rules_.is_usable = [this](int worker, std::size_t, const JointVector& q) {
      return moves_.has_clearance(worker, q);
    };
  }
  rules_.is_clear = [this](int worker, std::size_t interval, const JointVector& from,
                           const JointVector& to) {
    return moves_.is_clear(worker, interval, from, to);
  };
}

LadderPath GraphSearch::find_path(const std::vector<Rung>& rungs) {
  return find_least_cost_path(rungs, rules_, threads_, monitor_);
}

}  // namespace wristwise
