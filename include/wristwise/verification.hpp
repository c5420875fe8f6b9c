#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "wristwise/clearance.hpp"
#include "wristwise/seam.hpp"
#include "wristwise/trajectory.hpp"
#include "wristwise/visibility.hpp"

namespace WRISTWISE_PUBLIC wristwise {

/// What "passed" means, in numbers.
struct VerificationOptions {
  double position_tolerance = 1e-6;     ///< m, beyond the box at waypoints
  double angle_tolerance = 1e-6;        ///< rad, beyond the box at waypoints
  double joint_limit_tolerance = 1e-9;  ///< rad or m
  double clearance_tolerance = 1e-6;    ///< m, at waypoints
  double clearance_epsilon = 5e-5;      ///< m, of the claim for all t
  /// Further samples of deviation and clearance in each interval: a cross-check of what is shown
  /// for all t, which needs none.
  int samples_per_interval = 0;
};

/// From one time to another.
struct TimeRange {
  double from = 0;  ///< s
  double to = 0;    ///< s
};

/// Where a clearance could not be shown.
struct UnshownClearance {
  TimeRange range;             ///< when
  ClearanceModel::Names pair;  ///< of which bodies
};

/// The outcome of the independent check. Starts as "not run".
struct Verification {
  bool run = false;           ///< whether the check was made
  bool passed = false;        ///< made, and without failures
  bool curve = false;         ///< checked as a curve; else as points joined by straight moves
  TimeRange range;            ///< of the motion
  double position_error = 0;  ///< m, largest distance from the nominal TCP at waypoints, the
                              ///< tolerance box's own width taken off
  Vector6 tolerance_excess = Vector6::Zero();  ///< m, rad beyond the box at waypoints
  /// Largest beyond the box widened by `between` that was found, within 2% of the largest there is;
  /// 0 where nothing is beyond it by more than the position and angle tolerances.
  Vector6 tolerance_excess_between = Vector6::Zero();
  bool deviation_shown = false;  ///< inside the widened box for all t, to within the tolerances
  std::vector<TimeRange> deviation_not_shown;  ///< where that is not shown
  double path_error = 0;          ///< m: for all t the TCP is no farther from its place on the seam
  double angle_error = 0;         ///< rad: for all t no angle that is not free deviates more
  double joint_limit_excess = 0;  ///< rad or m
  /// m, the least of all t to within epsilon / 5, measured; nullopt where no pair counts.
  std::optional<double> clearance;
  std::optional<double> clearance_bound;  ///< m, shown for all t; nullopt where it is not shown
  std::vector<UnshownClearance> clearance_not_shown;  ///< where the required one is not shown
  ClearanceModel::Names clearance_pair;  ///< the nearest, where `clearance` is measured
  double clearance_time = 0;             ///< s, likewise
  double velocity_ratio = 0;             ///< largest |q'| / limit; > 1 is a failure
  double acceleration_ratio = 0;         ///< likewise |q''|; of points reported only
  double jerk_ratio = 0;                 ///< likewise |q'''|; of points reported only
  int velocity_joint = -1;               ///< whose velocity_ratio is the largest
  int acceleration_joint = -1;           ///< whose acceleration_ratio is the largest
  int jerk_joint = -1;                   ///< whose jerk_ratio is the largest
  double velocity_time = 0;              ///< s, when velocity_ratio is reached
  std::size_t samples = 0;               ///< postures looked at
  std::size_t distance_queries = 0;      ///< exact ones
  std::vector<std::string> failures;     ///< one line each: what, where, by how much
  std::vector<std::string> warnings;     ///< reported, but no reason to fail
};

/// Everything that is beyond a limit, a tolerance or a clearance, reason to fail or not.
std::vector<std::string> violations_of(const Verification& verification);

/// Checks points joined by straight joint-space moves. It is what check() of plan.hpp calls.
/// @param task seam, waypoints and tolerances
/// @param clearance model of the robot whose motion it is; not null
/// @param path n values a point
/// @param options what counts as passed
/// @throws InvalidInput where the path does not fit the robot
Verification verify(const Task& task, const std::shared_ptr<const ClearanceModel>& clearance,
                    const JointPath& path, const VerificationOptions& options = {});

/// Checks a curve, at waypoints and between them.
Verification verify(const Task& task, const std::shared_ptr<const ClearanceModel>& clearance,
                    const Trajectory& trajectory, const VerificationOptions& options = {});

}  // namespace wristwise
