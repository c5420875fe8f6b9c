#include "problem_check.hpp"

#include <fmt/format.h>

#include <cmath>

#include "wristwise/error.hpp"

namespace wristwise {

namespace {

void require_not_negative(double value, const char* name) {
  if (!(value >= 0)) throw InvalidInput(name, fmt::format("is {}", value), "0 or more");
}

void require_weight(double value, const char* name) {
  require_not_negative(value, name);
  if (std::isinf(value)) throw InvalidInput(name, "is infinite", "a number");
}

void require_positive(double value, const char* name) {
  if (!(value > 0 && std::isfinite(value)))
    throw InvalidInput(name, fmt::format("is {}", value), "more than 0");
}

/// A list with a finite value for each joint, or an empty one.
void require_per_joint(const std::vector<double>& values, int joints, const char* name) {
  if (values.empty()) return;
  if (values.size() != static_cast<std::size_t>(joints))
    throw InvalidInput(name, fmt::format("{} values for {} joints", values.size(), joints),
                       "one per joint, or none");
  for (const double value : values)
    if (!std::isfinite(value)) throw InvalidInput(name, fmt::format("has the value {}", value));
}

void check_task(const Task& task) {
  if (task.seam.pieces().empty()) throw InvalidInput("task.seam", "is empty", "a path");
  if (task.waypoints.size() < 2)
    throw InvalidInput("task.waypoints", fmt::format("{} of them", task.waypoints.size()),
                       "at least two");
  for (std::size_t i = 0; i < task.waypoints.size(); ++i) {
    const Waypoint& waypoint = task.waypoints[i];
    const std::string where = fmt::format("task.waypoints[{}]", i);
    if (!std::isfinite(waypoint.time) || !waypoint.frame.matrix().allFinite())
      throw InvalidInput(where, "a time or a frame that is not finite");
    if (i > 0 && waypoint.time <= task.waypoints[i - 1].time)
      throw InvalidInput(where, fmt::format("its time {} s does not increase", waypoint.time));
    if (!waypoint.joints) waypoint.tolerance.validate(where);
  }
  require_weight(task.between_position, "task.between_position");
  require_weight(task.between_angle, "task.between_angle");
}

void check_cost(const CostOptions& cost, int joints) {
  require_weight(cost.joint_motion, "cost.joint_motion");
  require_weight(cost.acceleration, "cost.acceleration");
  require_weight(cost.jerk, "cost.jerk");
  require_weight(cost.euler_graph, "cost.euler_graph");
  require_weight(cost.euler_refine, "cost.euler_refine");
  require_weight(cost.euler_eta, "cost.euler_eta");
  require_weight(cost.position_graph, "cost.position_graph");
  require_weight(cost.position_refine, "cost.position_refine");
  require_weight(cost.singularity_graph, "cost.singularity_graph");
  require_weight(cost.singularity_refine, "cost.singularity_refine");
  require_weight(cost.posture, "cost.posture");
  require_per_joint(cost.preferred_posture, joints, "cost.preferred_posture");
  require_per_joint(cost.joint_weights, joints, "cost.joint_weights");
  for (const double weight : cost.joint_weights) require_positive(weight, "cost.joint_weights");
  for (const PostureResidual& residual : cost.posture_residuals)
    if (!residual) throw InvalidInput("cost.posture_residuals", "an empty function");
}

void check_graph(const GraphOptions& graph, int joints) {
  for (const double step : graph.step) require_weight(step, "graph.step");
  require_per_joint(graph.joint_step, joints, "graph.joint_step");
  for (const double step : graph.joint_step) require_weight(step, "graph.joint_step");
  require_positive(graph.sparse_deviation, "graph.sparse_deviation");
  require_not_negative(graph.seed_separation, "graph.seed_separation");
  require_not_negative(graph.max_stray, "graph.max_stray");
  require_not_negative(graph.max_tcp_step, "graph.max_tcp_step");
  require_not_negative(graph.max_tcp_turn, "graph.max_tcp_turn");
}

void check_refine(const RefineOptions& refine) {
  require_positive(refine.smoothing_time, "refine.smoothing_time");
  require_weight(refine.knot_spacing, "refine.knot_spacing");
  require_positive(refine.constraint_tolerance, "refine.constraint_tolerance");
  require_positive(refine.clearance_epsilon, "refine.clearance_epsilon");
  require_not_negative(refine.time_limit, "refine.time_limit");
}

}  // namespace

void require_usable(const Problem& problem) {
  if (problem.robot == nullptr) throw InvalidInput("robot", "is null", "a robot");
  const int joints = problem.robot->joint_count();
  check_task(problem.task);
  check_cost(problem.cost, joints);
  check_graph(problem.graph, joints);
  check_refine(problem.refine);
  require_positive(problem.controller_period, "controller_period");
}

}  // namespace wristwise
