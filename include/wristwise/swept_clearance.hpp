#pragma once

#include <utility>

#include "wristwise/clearance.hpp"
#include "wristwise/visibility.hpp"

namespace WRISTWISE_PUBLIC wristwise {

/// A joint motion over s in [0, 1], with a bound on how far it strays.
class Motion {
 public:
  virtual ~Motion() = default;
  virtual JointVector posture(double s) const = 0;
  /// For each joint, a bound on |q(s) - q((s0 + s1) / 2)| for all s in [s0, s1].
  virtual JointVector spread(double s0, double s1) const = 0;
};

/// The straight joint-space move from one posture to another.
class StraightMove : public Motion {
 public:
  StraightMove(JointVector from, JointVector to) : from_(std::move(from)), to_(std::move(to)) {}
  JointVector posture(double s) const override;
  JointVector spread(double s0, double s1) const override;

 private:
  JointVector from_, to_;
};

struct SweptClearance {
  bool clear = false;
  /// Shown for all s: distance >= bound (m). +infinity where no pair counts, -infinity where the
  /// motion is not clear.
  double bound = 0;
  /// Where it is not clear: the place, and the nearest pair there with its distance.
  int pair = -1;
  double distance = 0;
  double s = 0;
  std::size_t postures = 0;  ///< sampled
};

/// Shows that a motion keeps every pair at `required` (m) or more, by bisection: an interval is
/// settled when the distance at its middle exceeds the motion bound of its half (F10).
/// Every sampled distance must be >= required - 1e-6; between samples the distance is shown to be
/// >= required - epsilon.
/// @param epsilon m, > 1e-6: where distance hugs `required`, the bisection ends here
/// @throws InvalidInput where an argument is not finite, or the motion's spread does not shrink
SweptClearance check_motion(ClearanceChecker& checker, const Motion& motion, double required,
                            double epsilon = 5e-5);

}  // namespace wristwise
