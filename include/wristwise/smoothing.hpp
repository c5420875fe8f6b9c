#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "wristwise/plan.hpp"
#include "wristwise/visibility.hpp"

namespace WRISTWISE_PUBLIC wristwise {

/// How a joint path is smoothed of which nothing else is known.
struct SmoothingOptions {
  /// m, > 0: how far the TCP may be, at any time, from where the path has it at that time.
  double position_tolerance = 5e-4;
  /// rad, in (0, pi): likewise the angle of the rotation between the two.
  double angle_tolerance = 0.5 * 0.017453292519943295;
  /// s, > 0; none: the time over which the motion is nearly straight (F53).
  std::optional<double> smoothing_time;
  /// Keep the links clear of each other, but for those that touch along the path itself.
  bool self_collision = true;
};

/// A joint path made into a problem: the TCP path that it draws, to be kept.
struct SmoothingProblem {
  Problem problem;  ///< to be handed to smooth() of plan.hpp with `path`
  /// One posture for each waypoint: the path as given, jumps by whole turns undone, with points
  /// added on its moves where its points are far apart.
  JointPath path;
  std::vector<std::string> warnings;  ///< one line each, such as jumps by whole turns
};

/// The problem of keeping the TCP path that `path`, its points joined by straight joint-space
/// moves, draws. Any chain: no inverse kinematics. Its tolerance boxes lie inside the tolerances'
/// balls (F51), for all t as far as the moves' deviation from the seam goes (F52). Where the path
/// stands still at its start or end, so does the result.
/// @throws InvalidInput for a path that does not fit the robot, points less than 10 us apart, or
/// options out of range.
SmoothingProblem smoothing_problem(const std::shared_ptr<const Robot>& robot, const JointPath& path,
                                   const SmoothingOptions& smoothing = {});

/// Smooths a joint path without a problem: smooth() of plan.hpp on its smoothing_problem().
PlanResult smooth(const std::shared_ptr<const Robot>& robot, const JointPath& path,
                  const SmoothingOptions& smoothing, const PlanOptions& options = {});

}  // namespace wristwise
