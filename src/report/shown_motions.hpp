#pragma once

#include <memory>
#include <string>
#include <vector>

#include "verify/checked_motion.hpp"
#include "wristwise/plan.hpp"

namespace wristwise {

/// A motion that is shown, with what it is measured by.
struct ShownMotion {
  std::string name;  ///< "two-stage", "graph-only", "smoothed", "as given"
  Task task;         ///< as the motion runs it, with a waypoint for each row that counts as one
  double weld_start = 0;                       ///< s
  double weld_end = 0;                         ///< s
  Trajectory trajectory;                       ///< the curve; empty: points
  JointPath path;                              ///< the points; of a curve its knots
  const Verification* verification = nullptr;  ///< null: it was not checked
};

/// The result, and behind it what it is compared with: the graph's own result where that is given,
/// else the path as it was given or the seed that refinement started from. None where there is no
/// motion. Points into `result` and `graph_only`.
/// @param graph_only may be null
std::vector<ShownMotion> shown_motions(const Problem& problem, const PlanResult& result,
                                       const PlanResult* graph_only);

/// Refers to the motion.
std::unique_ptr<CheckedMotion> checked_motion(const ShownMotion& motion);

}  // namespace wristwise
