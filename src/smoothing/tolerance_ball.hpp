#pragma once

#include "wristwise/tolerance.hpp"

namespace wristwise {

/// The largest box of equal widths, in the path frame, in which the TCP is at most `position` (m)
/// from the frame and turned by at most `angle` (rad, below pi) against it (F51).
ToleranceBox box_in_ball(double position, double angle);

}  // namespace wristwise
