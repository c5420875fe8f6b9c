#pragma once

// Refinements of the gantry, with everything they refer to.

#include "gantry.hpp"
#include "refine/refinement.hpp"

namespace wristwise::test {

constexpr double kDuration = 10;  // s
constexpr double kTau = 2;        // s

/// A refinement with everything it refers to.
struct Example {
  std::shared_ptr<const Robot> robot;
  Task task;
  std::shared_ptr<const ClearanceModel> clearance;
  CostOptions cost;
  RefineOptions options;
  Monitor monitor;

  Example(const Robot::Parts& parts, Task of, const std::vector<SceneObject>& objects = {},
          double required = 0)
      : robot(gantry::robot(parts)),
        task(std::move(of)),
        clearance(gantry::clearance(robot, objects, required)) {
    options.smoothing_time = kTau;
  }
  Refined run(const JointPath& seed) const {
    return refine({*robot, task, clearance, cost, options, monitor}, seed);
  }
  /// From the postures that follow the seam.
  Refined run() const { return run(gantry::path_along(task)); }
};

/// Wide boxes along a line, and given postures at the start, at 40 % and at the end.
inline Task three_point_task() {
  Task task = gantry::task({{0, 0, 0}, {1, 0, 0}}, kDuration, 100, gantry::box(1.5, 1));
  task.waypoints.front().joints = gantry::posture(0, 0, 0);
  task.waypoints[40].joints = gantry::posture(0.7, 0.3, -0.2, 0.1);
  task.waypoints.back().joints = gantry::posture(1, -0.1, 0, 0);
  return task;
}

inline JointPath three_point_seed(const Task& task) {
  JointPath seed = gantry::path_along(task);
  for (const std::size_t i : {std::size_t{0}, std::size_t{40}, std::size_t{100}}) {
    seed.positions[i] = task.waypoints[i].joints->nominal();
  }
  return seed;
}

constexpr double kBall = 0.05, kObstacle = 0.1, kRequired = 0.02;  // m

/// Straight past an obstacle that is in the way.
inline Example obstacle_example(const ToleranceBox& box, int intervals) {
  return {gantry::parts(kBall),
          gantry::task({{0, 0, 0}, {1, 0, 0}}, kDuration, intervals, box),
          {gantry::obstacle(Sphere{kObstacle}, 0.5, -0.01, 0)},
          kRequired};
}

}  // namespace wristwise::test
