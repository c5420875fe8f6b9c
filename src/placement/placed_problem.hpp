#pragma once

#include <string>
#include <vector>

#include "wristwise/placement.hpp"

namespace wristwise {

/// The motion of the part and of the objects that go with it, in the base frame: new pose =
/// motion * old pose. For Placed::robot what the base sees when it moves: the inverse of its own.
Pose motion_of(const PlacementRequest& request, const Offset& offset);

/// The objects that `motion_of` applies to, in the order of the scene.
std::vector<std::string> moving_objects(const PlacementRequest& request);

}  // namespace wristwise
