#include "export/fixed_number.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace wristwise {

std::string fixed_number(double value, int digits) {
  std::string text = fmt::format("{:.{}f}", value, digits);
  const bool zero = text.find_first_not_of("-0.") == std::string::npos;
  return zero && text[0] == '-' ? text.substr(1) : text;
}

std::int64_t RoundedClock::advance_to(double time, std::int64_t step) {
  const double units = time / unit_ - static_cast<double>(now_);
  const std::int64_t steps =
      std::max<std::int64_t>(1, std::llround(units / static_cast<double>(step)));
  now_ += steps * step;
  return steps * step;
}

}  // namespace wristwise
