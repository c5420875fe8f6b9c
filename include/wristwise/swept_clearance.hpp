#pragma once

#include <utility>

#include "wristwise/clearance.hpp"
#include "wristwise/visibility.hpp"

namespace WRISTWISE_PUBLIC wristwise {

/// A joint motion over s in [0, 1], with a bound on how far it strays.
class Motion {
 public:
  virtual ~Motion() = default;
  virtual JointVector posture(double s) const = 0;  ///< rad or m, one value for each joint
  /// For each joint, a bound on |q(s) - q((s0 + s1) / 2)| for all s in [s0, s1].
  virtual JointVector spread(double s0, double s1) const = 0;
};

/// The straight joint-space move from one posture to another.
class StraightMove : public Motion {
 public:
  /// From one posture to another of as many joints, rad or m.
  StraightMove(JointVector from, JointVector to) : from_(std::move(from)), to_(std::move(to)) {}
  JointVector posture(double s) const override;  ///< from at s = 0, to at s = 1
  /// Exact: half the way from posture(s0) to posture(s1).
  JointVector spread(double s0, double s1) const override;

 private:
  JointVector from_, to_;
};

/// What check_motion found.
struct SweptClearance {
  bool clear = false;  ///< the whole motion keeps the clearance
  /// Shown for all s: distance >= bound (m). +infinity where no pair counts, -infinity where the
  /// motion is not clear.
  double bound = 0;
  int pair = -1;             ///< where it is not clear: the nearest pair at the place found
  double distance = 0;       ///< m, of that pair there
  double s = 0;              ///< the place, 0 to 1
  std::size_t postures = 0;  ///< sampled
};

/// Shows that a motion keeps every pair at `required` (m) or more, by bisection: an interval is
/// settled when the distance at its middle exceeds the motion bound of its half (F10).
/// Every sampled distance must be >= required - 1e-6; between samples the distance is shown to be
/// >= required - epsilon.
/// @param checker of the robot that moves; its posture is changed
/// @param motion one value for each joint at each s
/// @param required m
/// @param epsilon m, > 1e-6: where distance hugs `required`, the bisection ends here
/// @throws InvalidInput where an argument is not finite, or the motion's spread does not shrink
SweptClearance check_motion(ClearanceChecker& checker, const Motion& motion, double required,
                            double epsilon = 5e-5);

}  // namespace wristwise
