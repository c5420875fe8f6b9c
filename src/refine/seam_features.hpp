#pragma once

#include <vector>

#include "wristwise/seam.hpp"

namespace wristwise {

/// A time inside the motion at which its curve needs short spans.
struct SeamFeature {
  double time = 0;           ///< s
  double finest = 0;         ///< s, the length of a span there
  bool off_waypoint = true;  ///< it may need spans shorter than the intervals between waypoints
};

/// Where the seam is not as smooth as a curve with spans of length `spacing` (s): knots of its time
/// law at which the third derivative jumps, ends of arcs, the ends of welding, rounded corners, and
/// corners that are run through at a lower speed. In order of time.
std::vector<SeamFeature> seam_features(const Task& task, double spacing);

}  // namespace wristwise
