#pragma once

#include <vector>

namespace wristwise {

/// A value over time, or some: times ascend, as many values as times. A value that is not finite
/// breaks the line.
struct TimeSeries {
  std::vector<double> times;  ///< s
  std::vector<double> values;
};

}  // namespace wristwise
