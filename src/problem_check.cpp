#include "problem_check.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

#include "wristwise/error.hpp"

namespace wristwise {

namespace {

constexpr double kTimeTolerance = 1e-6;  // s, by which waypoints may miss the seam's ends

void expect(bool holds, const std::string& where, double value, const char* expected) {
  if (!holds) throw InvalidInput(where, fmt::format("{}", value), expected);
}

void not_negative(const std::string& where, double value) {
  expect(std::isfinite(value) && value >= 0, where, value, "a finite number, 0 or more");
}

void positive(const std::string& where, double value) {
  expect(std::isfinite(value) && value > 0, where, value, "a finite number above 0");
}

/// Infinity: no limit.
void positive_limit(const std::string& where, double value) {
  expect(value > 0, where, value, "a number above 0, or infinity");
}

void at_least(const std::string& where, int value, int least) {
  if (value < least)
    throw InvalidInput(where, std::to_string(value), std::to_string(least) + " or more");
}

using Rule = void (*)(const std::string&, double);

/// Empty, or one for each joint.
void per_joint(const std::string& where, const std::vector<double>& values, int joints, Rule rule) {
  if (values.empty()) return;
  if (values.size() != static_cast<std::size_t>(joints))
    throw InvalidInput(where, fmt::format("{} values", values.size()),
                       fmt::format("{}, one for each joint, or none", joints));
  for (std::size_t j = 0; j < values.size(); ++j) rule(fmt::format("{}[{}]", where, j), values[j]);
}

void finite(const std::string& where, double value) {
  expect(std::isfinite(value), where, value, "a finite number");
}

void check_cost(const CostOptions& cost, int joints) {
  not_negative("cost.joint_motion", cost.joint_motion);
  not_negative("cost.acceleration", cost.acceleration);
  not_negative("cost.jerk", cost.jerk);
  not_negative("cost.euler_graph", cost.euler_graph);
  not_negative("cost.euler_refine", cost.euler_refine);
  not_negative("cost.euler_eta", cost.euler_eta);
  not_negative("cost.position_graph", cost.position_graph);
  not_negative("cost.position_refine", cost.position_refine);
  not_negative("cost.singularity_graph", cost.singularity_graph);
  not_negative("cost.singularity_refine", cost.singularity_refine);
  not_negative("cost.posture", cost.posture);
  per_joint("cost.preferred_posture", cost.preferred_posture, joints, finite);
  per_joint("cost.joint_weights", cost.joint_weights, joints, positive);
  for (const PostureResidual& residual : cost.posture_residuals)
    if (!residual) throw InvalidInput("cost.posture_residuals", "an empty function");
}

void check_graph(const GraphOptions& graph, int joints) {
  for (int i = 0; i < graph.step.size(); ++i)
    not_negative(fmt::format("graph.step[{}]", i), graph.step[i]);
  per_joint("graph.joint_step", graph.joint_step, joints, not_negative);
  at_least("graph.automatic_samples", graph.automatic_samples, 0);
  positive("graph.sparse_deviation", graph.sparse_deviation);
  at_least("graph.seeds", graph.seeds, 1);
  at_least("graph.spare_seeds", graph.spare_seeds, 0);
  positive("graph.seed_separation", graph.seed_separation);
  positive_limit("graph.max_stray", graph.max_stray);
  positive_limit("graph.max_tcp_step", graph.max_tcp_step);
  positive_limit("graph.max_tcp_turn", graph.max_tcp_turn);
}

void check_refine(const RefineOptions& refine) {
  positive("refine.smoothing_time", refine.smoothing_time);
  not_negative("refine.knot_spacing", refine.knot_spacing);
  at_least("refine.max_rounds", refine.max_rounds, 1);
  at_least("refine.max_iterations", refine.max_iterations, 1);
  positive("refine.constraint_tolerance", refine.constraint_tolerance);
  positive("refine.clearance_epsilon", refine.clearance_epsilon);
  expect(refine.time_limit >= 0, "refine.time_limit", refine.time_limit,
         "a number, 0 or more, or infinity");
}

void expect_on_seam(const std::string& where, double time, const Seam& seam) {
  if (time < seam.start_time() - kTimeTolerance || time > seam.end_time() + kTimeTolerance)
    throw InvalidInput(where, fmt::format("{} s is not on the seam", time),
                       fmt::format("{} to {} s", seam.start_time(), seam.end_time()));
}

void check_waypoints(const Task& task) {
  const std::vector<Waypoint>& waypoints = task.waypoints;
  if (waypoints.size() < 2)
    throw InvalidInput("task.waypoints", fmt::format("{} given", waypoints.size()), "at least two");
  for (std::size_t i = 0; i < waypoints.size(); ++i) {
    const std::string where = fmt::format("task.waypoints[{}]", i);
    finite(where + ".time", waypoints[i].time);
    expect_on_seam(where + ".time", waypoints[i].time, task.seam);
    if (i > 0 && waypoints[i].time <= waypoints[i - 1].time)
      throw InvalidInput(where + ".time", fmt::format("{} s", waypoints[i].time),
                         "one that increases from waypoint to waypoint");
    if (waypoints[i].joints) continue;
    if (!waypoints[i].frame.matrix().allFinite())
      throw InvalidInput(where + ".frame", "not finite", "a pose");
    waypoints[i].tolerance.validate(where + ".tolerance");
  }
}

}  // namespace

void check_task(const Problem& problem) {
  if (!problem.robot) throw InvalidInput("problem.robot", "none", "a robot");
  if (problem.task.seam.pieces().empty())
    throw InvalidInput("task.seam", "no pieces", "at least one");
  check_waypoints(problem.task);
  not_negative("task.between_position", problem.task.between_position);
  not_negative("task.between_angle", problem.task.between_angle);
  positive("refine.clearance_epsilon", problem.refine.clearance_epsilon);
}

void check_problem(const Problem& problem) {
  check_task(problem);
  const int joints = problem.robot->joint_count();
  check_cost(problem.cost, joints);
  check_graph(problem.graph, joints);
  check_refine(problem.refine);
  positive("problem.controller_period", problem.controller_period);
}

}  // namespace wristwise
