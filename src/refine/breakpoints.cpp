#include "refine/breakpoints.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace wristwise {

std::vector<double> choose_breakpoints(const std::vector<double>& times, double spacing) {
  std::vector<double> breakpoints = {times.front()};
  for (std::size_t i = 1; i < times.size(); ++i) {
    const double rounding = 0.5 * (times[i] - times[i - 1]);
    if (times[i] - breakpoints.back() >= (spacing - rounding) * (1 - 1e-9))
      breakpoints.push_back(times[i]);
  }
  if (breakpoints.back() < times.back()) {
    const bool crowded =
        breakpoints.size() > 1 && times.back() - breakpoints.back() < 0.5 * spacing;
    if (crowded) breakpoints.pop_back();
    breakpoints.push_back(times.back());
  }
  return breakpoints;
}

std::vector<double> every_nth(const std::vector<double>& breakpoints, std::size_t n) {
  std::vector<double> coarse;
  const std::size_t spans = breakpoints.size() - 1;
  const std::size_t kept = std::max<std::size_t>(1, spans / n);
  for (std::size_t k = 0; k <= kept; ++k) coarse.push_back(breakpoints[k * spans / kept]);
  return coarse;
}

std::vector<double> with_split_spans(const std::vector<double>& breakpoints,
                                     const std::vector<double>& at,
                                     const std::vector<double>& preferred, double shortest) {
  std::vector<double> result = breakpoints;
  for (std::size_t i = 0; i + 1 < breakpoints.size(); ++i) {
    const double from = breakpoints[i], to = breakpoints[i + 1], width = to - from;
    if (width < 2 * shortest) continue;
    const auto in_span = std::lower_bound(at.begin(), at.end(), from);
    if (in_span == at.end() || *in_span > to) continue;
    const double middle = 0.5 * (from + to);
    const auto after = std::lower_bound(preferred.begin(), preferred.end(), middle);
    double best = middle, distance = width / 4;
    for (auto time = after == preferred.begin() ? after : std::prev(after);
         time != preferred.end() && *time < to; ++time) {
      if (std::abs(*time - middle) >= distance) continue;
      best = *time;
      distance = std::abs(*time - middle);
    }
    result.push_back(best);
  }
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace wristwise
