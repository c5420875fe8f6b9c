#include "refine/breakpoints.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <set>
#include <utility>

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

std::vector<double> with_long_spans_cut(const std::vector<double>& breakpoints, double spacing) {
  std::vector<double> result = {breakpoints.front()};
  for (std::size_t i = 0; i + 1 < breakpoints.size(); ++i) {
    const double from = breakpoints[i], to = breakpoints[i + 1];
    const auto parts = static_cast<int>(std::max(1.0, std::round((to - from) / spacing)));
    for (int k = 1; k < parts; ++k) result.push_back(from + k * (to - from) / parts);
    result.push_back(to);
  }
  return result;
}

std::vector<double> graded(const std::vector<double>& breakpoints,
                           const std::vector<SeamFeature>& features) {
  constexpr double kGrowth = 1.5;
  const double first = breakpoints.front(), last = breakpoints.back();
  const double widest = (last - first) / static_cast<double>(breakpoints.size() - 1);
  // Candidates by the spacing that is wanted at each; what is too near to a finer one goes.
  std::vector<std::pair<double, double>> candidates;
  candidates.reserve(breakpoints.size());
  for (const double t : breakpoints) candidates.emplace_back(widest, t);
  for (const SeamFeature& feature : features) {
    candidates.emplace_back(0.5 * feature.finest, feature.time);
    double offset = 0, step = feature.finest;
    while (step < widest) {
      offset += step;
      candidates.emplace_back(step, feature.time - offset);
      candidates.emplace_back(step, feature.time + offset);
      step *= kGrowth;
    }
  }
  std::sort(candidates.begin(), candidates.end());
  std::set<double> kept = {first, last};
  for (const auto& [step, t] : candidates) {
    if (t <= first || t >= last) continue;
    const double room = 0.6 * step;
    const auto next = kept.lower_bound(t);
    if (*next - t >= room && t - *std::prev(next) >= room) kept.insert(t);
  }
  return {kept.begin(), kept.end()};
}

std::vector<double> every_nth(const std::vector<double>& breakpoints, std::size_t n) {
  std::vector<double> coarse;
  const std::size_t spans = breakpoints.size() - 1;
  const std::size_t kept = std::max<std::size_t>(1, spans / n);
  for (std::size_t k = 0; k <= kept; ++k) coarse.push_back(breakpoints[k * spans / kept]);
  return coarse;
}

namespace {

/// Adds where(from, to) for each span [from, to] that holds one of the times `at`.
template <class Where>
std::vector<double> split(const std::vector<double>& breakpoints, const std::vector<double>& at,
                          const Where& where) {
  std::vector<double> result = breakpoints;
  for (std::size_t i = 0; i + 1 < breakpoints.size(); ++i) {
    const double from = breakpoints[i], to = breakpoints[i + 1];
    const auto in_span = std::lower_bound(at.begin(), at.end(), from);
    if (in_span == at.end() || *in_span > to) continue;
    if (const std::optional<double> place = where(from, to)) result.push_back(*place);
  }
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace

std::vector<double> split_at_places(const std::vector<double>& breakpoints,
                                    const std::vector<double>& at,
                                    const std::vector<double>& places) {
  return split(breakpoints, at, [&](double from, double to) {
    std::optional<double> best;
    const double middle = 0.5 * (from + to);
    for (auto place = std::upper_bound(places.begin(), places.end(), from);
         place != places.end() && *place < to; ++place) {
      if (!best || std::abs(*place - middle) < std::abs(*best - middle)) best = *place;
    }
    return best;
  });
}

std::vector<double> split_in_halves(const std::vector<double>& breakpoints,
                                    const std::vector<double>& at, double shortest) {
  return split(breakpoints, at, [&](double from, double to) {
    return to - from >= 2 * shortest ? std::optional<double>(0.5 * (from + to)) : std::nullopt;
  });
}

}  // namespace wristwise
