#pragma once

#include "wristwise/seam_description.hpp"

namespace wristwise {

/// The same description with a name for every part that has none.
/// @throws InvalidInput for values that are not finite, lists of different sizes, and tolerance
/// boxes that are none.
SeamDescription checked_description(SeamDescription description);

}  // namespace wristwise
