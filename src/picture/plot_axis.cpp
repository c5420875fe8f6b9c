#include "picture/plot_axis.hpp"

#include <fmt/format.h>

#include <cmath>

namespace wristwise {

namespace {

constexpr double kRoundOff = 1e-9;  // of a step

double round_step(double least) {
  const double power = std::pow(10, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= least * (1 - kRoundOff)) return factor * power;
  return 10 * power;
}

}  // namespace

std::vector<double> ticks(const PlotAxis& axis, int count) {
  if (!(axis.to > axis.from)) return {axis.from};
  const double step = round_step((axis.to - axis.from) / count);
  const double first = std::ceil(axis.from / step - kRoundOff);
  const double last = std::floor(axis.to / step + kRoundOff);
  std::vector<double> values;
  for (int k = 0; k <= static_cast<int>(last - first); ++k) values.push_back((first + k) * step);
  return values;
}

std::string tick_text(double value) { return fmt::format("{:.6g}", value + 0.0); }

}  // namespace wristwise
