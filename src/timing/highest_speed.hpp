#pragma once

#include <functional>
#include <optional>

namespace wristwise {

/// The least factor of time, more than 1 and to 2%, that works, found by trying; nullopt where none
/// of those tried does.
/// @param works whether a factor does; 1 does not
/// @param guess where to begin, more than 1
std::optional<double> least_working_factor(const std::function<bool(double)>& works, double guess);

}  // namespace wristwise
