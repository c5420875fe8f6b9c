#pragma once

#include <vector>

#include "wristwise/pose.hpp"

namespace wristwise {

struct StraightTime {
  double time = 0;        ///< s
  bool straight = false;  ///< false: the motion bends, or its noise is, more than the tolerance
                          ///< from point to point
};

/// The time over which a motion is nearly straight (F53): the longest of a quarter of the duration
/// and what is 2^(1/4), 2^(2/4), 2^(3/4), ... times shorter for which, nine times out of ten, the
/// middle of so long a stretch is within `position` (m) and `angle` (rad) of the line between its
/// ends. At least two and a half steps, where a quarter of the duration is that long.
/// @pre at least two increasing times (s), one pose for each
StraightTime straight_time(const std::vector<double>& times, const std::vector<Pose>& poses,
                           double position, double angle);

}  // namespace wristwise
