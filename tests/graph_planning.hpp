#pragma once

// A gantry's task with everything that stage 1 needs.

#include "graph/graph_planner.hpp"

#include "gantry_ik.hpp"

namespace wristwise::test::gantry {

struct Planning {
  Robot::Parts parts = gantry::parts();
  Task task = gantry::task({{0, 0, 0}, {1, 0, 0}}, 20, 20, gantry::box(0, 0));
  std::vector<SceneObject> objects;
  double required = 0;
  CostOptions cost;
  GraphOptions options;
  ExactIk ik;
  std::shared_ptr<const Robot> robot;
  std::shared_ptr<const ClearanceModel> model;

  SamplingInput input() {
    robot = gantry::robot(parts);
    model = gantry::clearance(robot, objects, required);
    return {*robot, ik, model, cost, options};
  }
  GraphPlan plan(int threads = 2) {
    const SamplingInput with = input();
    Timing timing;
    return plan_graph(with, task, 5e-5, threads, {}, timing);
  }
  /// Being off the seam costs this much per m and waypoint.
  void pull_to_seam(double weight) {
    cost.vertex_cost = [weight](std::size_t, const JointVector& q) {
      return weight * std::abs(q[1]);
    };
  }
  void allow(int coordinate, double by, double step) {
    for (Waypoint& waypoint : task.waypoints) {
      waypoint.tolerance.lower[coordinate] = -by;
      waypoint.tolerance.upper[coordinate] = by;
    }
    options.step[coordinate] = step;
  }
};

}  // namespace wristwise::test::gantry
