#pragma once

#include "wristwise/seam_description.hpp"

namespace wristwise {

/// The seam when the part has been moved by a motion given in the base frame. Joint waypoints stay.
SeamDescription moved(SeamDescription seam, const Pose& motion);

}  // namespace wristwise
