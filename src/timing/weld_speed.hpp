#pragma once

#include <functional>
#include <optional>

#include "refine/refinement.hpp"
#include "timing/uniform_speed.hpp"

namespace wristwise {

/// What stage 2 makes of a seed under the task's speed policy.
struct SpeedRefined {
  Refined refined;
  Task task;       ///< the input's, or where it had to be slowed that at its new times
  Trajectory law;  ///< where it was slowed: one joint, the input's time over the new one
  /// Where nothing but velocity, acceleration and jerk limits is in the way: what breaks them most
  /// on the curve in `refined`, which was made without them, at weld speed.
  std::optional<UniformSlowdown> too_fast;
};

/// Whether a motion passes the check of a task.
using MotionCheck = std::function<bool(const Task&, const Trajectory&)>;

/// Stage 2 at weld speed; with SpeedPolicy::slow, where the limits can't be met, under a time law
/// that is slower where the motion without limits breaks them (F27).
SpeedRefined refine_at_weld_speed(const RefinementInput& input, const JointPath& seed,
                                  const MotionCheck& passes);

}  // namespace wristwise
