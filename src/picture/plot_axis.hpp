#pragma once

#include <string>
#include <vector>

namespace wristwise {

/// Values along a line of pixels.
struct PlotAxis {
  double from = 0, to = 1;                 ///< values at the ends, from < to
  double first_pixel = 0, last_pixel = 1;  ///< there

  double pixel(double value) const {
    return first_pixel + (value - from) / (to - from) * (last_pixel - first_pixel);
  }
};

/// Round values within the axis, about `count` of them: multiples of 1, 2 or 5 times a power of 10.
std::vector<double> ticks(const PlotAxis& axis, int count = 6);

/// A tick's value without the noise of its last digits.
std::string tick_text(double value);

}  // namespace wristwise
