#pragma once

#include "timing/motion_rates.hpp"

namespace wristwise {

/// What asks for most time when a whole motion is run slower.
struct UniformSlowdown {
  double factor = 0;   ///< of time; at most 1 where the limits hold as it is
  double ratio = 0;    ///< |rate| / limit at full speed
  int joint = -1;      ///< of that rate; -1 where nothing moves or nothing is limited
  int derivative = 0;  ///< 1 velocity, 2 acceleration, 3 jerk
  double time = 0;     ///< s, of the piece's point at which the rate is largest
};

/// The least factor by which all times must be stretched for the limits to hold for all t: rates of
/// order k fall with its k-th power (F28).
UniformSlowdown uniform_slowdown(const Trajectory& motion, const Rates& limits);

/// `motion` over the same values in `factor` times the time, from its first time on.
Trajectory stretched(const Trajectory& motion, double factor);

}  // namespace wristwise
