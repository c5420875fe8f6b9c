#pragma once

#include "wristwise/problem.hpp"

namespace wristwise {

/// What a problem file's reader sees to, for a problem from anywhere: that there is a robot and a
/// seam with waypoints in order of time, and that options are inside their ranges and of the
/// robot's number of joints.
/// @throws InvalidInput naming the option
void check_problem(const Problem& problem);

/// The same without what only a search needs: for a trajectory that is there already.
void check_task(const Problem& problem);

}  // namespace wristwise
