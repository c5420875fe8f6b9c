#pragma once

#include <vector>

#include "task/stretches.hpp"

namespace wristwise {

/// Real time over nominal time of a smooth start and stop from rest to rest: the peak of the rate
/// is 1 (F22).
inline constexpr double kRestToRest = 15.0 / 8.0;

/// The rate of the nominal time at one nominal time; between two knots it goes over smoothly.
struct PaceKnot {
  double nominal = 0;  ///< s
  double rate = 1;
};

/// What the speed of the seam does where stretches end at another speed than that of the weld:
/// nothing where none does.
/// @param ends nominal times (s) at which the stretches end
/// @param ramp_time s, real, from one rate to another
/// @throws InvalidInput naming a stretch that is too short to ramp on.
std::vector<PaceKnot> pace_of(const std::vector<Stretch>& stretches, double start,
                              const std::vector<double>& ends, double ramp_time);

/// The time law of a pace (F22); real time is nominal time at the first knot.
Trajectory seam_time_of(const std::vector<PaceKnot>& pace);

}  // namespace wristwise
