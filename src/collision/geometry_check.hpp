#pragma once

#include <string>

#include "wristwise/geometry.hpp"

namespace wristwise {

/// @throws InvalidInput where a size is not positive and finite, a hull has no four vertices or a
/// pose is not finite.
void check_shape(const std::string& where, const Shape& shape);

}  // namespace wristwise
