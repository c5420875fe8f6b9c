#pragma once

#include "timing/motion_rates.hpp"

namespace wristwise {

struct SpeedProfileOptions {
  double margin = 0.98;  ///< of the limits that the motion may use, in (0, 1]
  double spacing = 0;    ///< s, between breakpoints of the profile; 0: a 200th of the motion
  /// No times of the law but those of the motion, so that who knows it there knows it everywhere;
  /// else no farther apart than `spacing`.
  bool only_motion_times = false;
};

/// The time law under which a motion keeps its limits: one joint, the motion's own time tau over
/// real time t, from the motion's first time on. 0 < d tau / dt <= 1, twice continuously
/// differentiable; 1 where the limits allow it, and in as little time as can be found (F27). The
/// motion's times are reached at times of the law.
/// @throws InvalidInput for limits that are not positive, a margin outside (0, 1] or a spacing that
/// is negative or not finite.
Trajectory speed_profile(const Trajectory& motion, const Rates& limits,
                         const SpeedProfileOptions& options = {});

}  // namespace wristwise
