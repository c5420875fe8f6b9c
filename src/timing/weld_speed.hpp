#pragma once

#include <functional>
#include <optional>

#include "refine/refinement.hpp"
#include "timing/uniform_speed.hpp"

namespace wristwise {

/// What stage 2 makes of a seed where it can't meet every constraint at weld speed.
struct SpeedRefined {
  Refined refined;
  Task task;       ///< the input's, or where it had to be slowed that at its new times
  Trajectory law;  ///< where it was slowed: one joint, the input's time over the new one
  /// Where the weld speed can't be held: what breaks its limit most on the curve in `refined`,
  /// which was made without limits of velocity, acceleration and jerk.
  std::optional<UniformSlowdown> too_fast;
};

/// Whether a motion passes the check of a task.
using MotionCheck = std::function<bool(const Task&, const Trajectory&)>;

/// Whether a seed of which stage 2 made nothing feasible fails because of the weld speed: nullopt
/// where it does so without limits of velocity, acceleration and jerk too. With SpeedPolicy::slow
/// the seam is run slower where the motion without limits breaks them (F27).
std::optional<SpeedRefined> refine_at_other_speed(const RefinementInput& input,
                                                  const JointPath& seed, const MotionCheck& passes);

}  // namespace wristwise
