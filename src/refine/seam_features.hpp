#pragma once

#include <vector>

#include "wristwise/seam.hpp"

namespace wristwise {

/// A time inside the motion at which its curve needs short spans.
struct SeamFeature {
  double time = 0;    ///< s
  double finest = 0;  ///< s, the length of a span there
};

/// Where the seam is not as smooth as a curve with spans of length `spacing` (s): knots of its time
/// law at which the third derivative jumps, the ends of welding, rounded corners, and corners that
/// are run through at a lower speed. In order of time.
std::vector<SeamFeature> seam_features(const Task& task, double spacing);

}  // namespace wristwise
