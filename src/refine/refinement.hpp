#pragma once

#include <memory>

#include "wristwise/monitor.hpp"
#include "wristwise/plan.hpp"

namespace wristwise {

/// What stage 2 works on.
struct RefinementInput {
  const Robot& robot;
  const Task& task;
  std::shared_ptr<const ClearanceModel> clearance;
  const CostOptions& cost;
  const RefineOptions& options;
  const Monitor& monitor;
};

struct Refined {
  Trajectory trajectory;  ///< through the waypoints
  bool feasible = false;  ///< every constraint holds at its points, and no dip is left between them
  RefineStatistics statistics;
};

/// Irons a seed path, one posture for each waypoint, into a quintic spline: minimises the objective
/// (F14) under tolerance box, joint, velocity, acceleration and jerk limits and clearance by an
/// augmented Lagrangian (F16), adding constraint points where a check between them finds a dip.
Refined refine(const RefinementInput& input, const JointPath& seed);

}  // namespace wristwise
