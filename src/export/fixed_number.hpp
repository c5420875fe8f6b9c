#pragma once

#include <cstdint>
#include <string>

namespace wristwise {

/// A number with so many digits after the point; never "-0.000".
std::string fixed_number(double value, int digits);

/// A clock in whole units, so that rounded durations do not add up to another time.
class RoundedClock {
 public:
  explicit RoundedClock(double unit) : unit_(unit) {}  ///< s

  /// Units from where the clock stands to the time (s), rounded to a multiple of `step` units; at
  /// least one step. The clock then stands there.
  std::int64_t advance_to(double time, std::int64_t step = 1);

 private:
  double unit_;
  std::int64_t now_ = 0;
};

}  // namespace wristwise
