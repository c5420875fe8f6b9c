#pragma once

#include <string>
#include <vector>

#include "wristwise/robot.hpp"
#include "wristwise/trajectory.hpp"

namespace wristwise {

struct Unwrapped {
  JointPath path;
  std::vector<std::string> warnings;  ///< one for each joint with jumps
};

/// Undoes jumps by whole turns, as a recorder makes them that wraps angles: steps of more than half
/// a turn of a turning joint that its speed limit does not allow. The joint is then shifted as a
/// whole, by the fewest whole turns, to where it is inside its limits; where there is no such
/// place it stays as it is.
Unwrapped without_whole_turns(const Robot& robot, const JointPath& path);

}  // namespace wristwise
