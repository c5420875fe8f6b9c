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
  bool stopped = false;   ///< before its end, by the caller or the time limit
  RefineStatistics statistics;
};

/// Holding every constraint counts first, then the objective, or how much is violated.
bool is_better(const Refined& a, const Refined& b);

/// Irons a seed path, one posture for each waypoint, into a quintic spline: minimises the objective
/// (F14) under tolerance box, joint, velocity, acceleration and jerk limits and clearance by an
/// augmented Lagrangian (F16), adding constraint points where a check between them finds a dip.
/// Stopped early it returns the best motion so far that holds everything.
/// @throws Cancelled where the caller stops it before there is one
Refined refine(const RefinementInput& input, const JointPath& seed);

}  // namespace wristwise
