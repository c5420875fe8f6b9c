#include "picture/percent.hpp"

#include <fmt/format.h>

#include <cmath>

namespace wristwise {

std::string percent(double share) {
  if (!std::isfinite(share)) return "-";
  if (share != 0 && share < 1e-4) return "<0.01%";
  return share < 0.995 ? fmt::format("{:.2g}%", 100 * share) : fmt::format("{:.0f}%", 100 * share);
}

}  // namespace wristwise
