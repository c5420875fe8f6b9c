#pragma once

#include "wristwise/problem.hpp"

namespace wristwise {

/// What every problem must fulfil, whether it was read from a file or built in code.
/// @throws InvalidInput naming the member: no robot, fewer than two waypoints, times that do not
/// increase, frames or options that are not finite or out of range, lists that do not fit the
/// robot.
void require_usable(const Problem& problem);

}  // namespace wristwise
