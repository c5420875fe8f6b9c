#pragma once

#include "wristwise/visibility.hpp"

namespace WRISTWISE_PUBLIC wristwise {

/// What becomes of the corners of a seam.
struct CornerOptions {
  /// What happens at a corner.
  enum class Kind {
    keep,   ///< run at weld speed
    stop,   ///< come to rest, and turn the torch while it stands
    slow,   ///< run slower
    blend,  ///< round off
  };
  Kind kind = Kind::keep;                        ///< says which members below count
  double ramp_time = 0.5;                        ///< s, stop and slow: before and after
  double turn_rate = 30 * 0.017453292519943295;  ///< rad/s, stop: at most, of the frame
  double speed_ratio = 0.2;                      ///< slow: share of the weld speed
  double distance = 0;                           ///< m, blend: of its ends from the corner
};

}  // namespace wristwise
