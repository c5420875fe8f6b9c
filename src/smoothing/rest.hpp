#pragma once

#include <vector>

#include "wristwise/pose.hpp"

namespace wristwise {

/// Whether a motion stands still, but for `position` (m) and `angle` (rad), for `duration` (s) at
/// its start; at its end.
/// @pre at least two increasing times (s), one pose for each
bool rests_at_start(const std::vector<double>& times, const std::vector<Pose>& poses,
                    double duration, double position, double angle);
bool rests_at_end(const std::vector<double>& times, const std::vector<Pose>& poses, double duration,
                  double position, double angle);

}  // namespace wristwise
