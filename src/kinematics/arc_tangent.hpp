#pragma once

#include <cstddef>

namespace wristwise {

/// angle[i] in (-pi, pi] of the direction (x[i], y[i]): std::atan2(y[i], x[i]) within 2 units in
/// the last place, for finite arguments, but pi where that is -pi. The same bits on every machine
/// and at every place in the array.
void angles_of_directions(std::size_t count, const double* x, const double* y, double* angle);

}  // namespace wristwise
