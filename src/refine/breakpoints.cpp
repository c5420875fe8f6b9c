#include "refine/breakpoints.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

namespace wristwise {

namespace {

constexpr double kGrowth = 0.5;  ///< of the length of a span to its neighbour's

/// Indices of the values, ascending, that are as near to `spacing` apart as the values allow.
std::vector<std::size_t> spread(const std::vector<double>& values, double spacing) {
  std::vector<std::size_t> chosen = {0};
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double rounding = 0.5 * (values[i] - values[i - 1]);
    if (values[i] - values[chosen.back()] >= (spacing - rounding) * (1 - 1e-9)) chosen.push_back(i);
  }
  const std::size_t last = values.size() - 1;
  if (chosen.back() < last) {
    const bool crowded = chosen.size() > 1 && values[last] - values[chosen.back()] < 0.5 * spacing;
    if (crowded) chosen.pop_back();
    chosen.push_back(last);
  }
  return chosen;
}

std::vector<double> at_indices(const std::vector<double>& values,
                               const std::vector<std::size_t>& indices) {
  std::vector<double> result;
  result.reserve(indices.size());
  for (const std::size_t i : indices) result.push_back(values[i]);
  return result;
}

/// How many spans there are up to each of the places `at` (ascending) where a span may be as long
/// as `longest`, turn by `turn`, and be longer than its neighbour by a half.
/// @param turned up to each place, rad
std::vector<double> count_spans(const std::vector<double>& at, const std::vector<double>& turned,
                                double longest, double turn) {
  const std::size_t intervals = at.size() - 1;
  std::vector<double> length(intervals), width(intervals);
  for (std::size_t i = 0; i < intervals; ++i) {
    width[i] = at[i + 1] - at[i];
    length[i] = std::min(longest, turn * width[i] / (turned[i + 1] - turned[i]));
  }
  for (std::size_t i = 1; i < intervals; ++i)
    length[i] = std::min(length[i], length[i - 1] + kGrowth * width[i]);
  for (std::size_t i = intervals; i > 1; --i)
    length[i - 2] = std::min(length[i - 2], length[i - 1] + kGrowth * width[i - 2]);
  std::vector<double> count(at.size(), 0.0);
  for (std::size_t i = 0; i < intervals; ++i) count[i + 1] = count[i] + width[i] / length[i];
  return count;
}

std::vector<double> turned_until(const std::vector<double>& times, const SeamTurning& turning) {
  std::vector<double> turned;
  turned.reserve(times.size());
  for (const double t : times) turned.push_back(turning.until(t));
  return turned;
}

}  // namespace

std::vector<double> choose_breakpoints(const std::vector<double>& times, double spacing) {
  return at_indices(times, spread(times, spacing));
}

std::vector<double> choose_breakpoints(const std::vector<double>& times, double spacing,
                                       const SeamTurning& turning, double turn) {
  const std::vector<double> turned = turned_until(times, turning);
  return at_indices(times, spread(count_spans(times, turned, spacing, turn), 1));
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
  const double first = breakpoints.front(), last = breakpoints.back();
  const double widest = (last - first) / static_cast<double>(breakpoints.size() - 1);
  // Candidates by the spacing that is wanted at each; what is too near to a finer one goes.
  std::vector<std::pair<double, double>> candidates;
  candidates.reserve(breakpoints.size());
  for (std::size_t i = 1; i + 1 < breakpoints.size(); ++i) {
    const double narrower =
        std::min(breakpoints[i] - breakpoints[i - 1], breakpoints[i + 1] - breakpoints[i]);
    candidates.emplace_back(std::min(widest, narrower), breakpoints[i]);
  }
  for (const SeamFeature& feature : features) {
    candidates.emplace_back(0.5 * feature.finest, feature.time);
    double offset = 0, step = feature.finest;
    while (step < widest) {
      offset += step;
      candidates.emplace_back(step, feature.time - offset);
      candidates.emplace_back(step, feature.time + offset);
      step *= 1 + kGrowth;
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

std::vector<double> moved_to(const std::vector<double>& times,
                             const std::vector<double>& breakpoints) {
  std::vector<double> result;
  for (const double t : breakpoints) {
    const auto after = std::lower_bound(times.begin(), times.end(), t);
    const bool before_is_nearer =
        after == times.end() || (after != times.begin() && t - *std::prev(after) < *after - t);
    const double nearest = before_is_nearer ? *std::prev(after) : *after;
    if (result.empty() || result.back() < nearest) result.push_back(nearest);
  }
  return result;
}

std::vector<double> every_nth(const std::vector<double>& breakpoints, std::size_t n,
                              const SeamTurning& turning, double turn) {
  std::vector<double> places(breakpoints.size());
  std::iota(places.begin(), places.end(), 0.0);
  const std::vector<double> count =
      count_spans(places, turned_until(breakpoints, turning), static_cast<double>(n), turn);
  const double spans = std::max(1.0, std::floor(count.back() * (1 + 1e-9)));
  std::vector<double> coarse = {breakpoints.front()};
  for (std::size_t i = 1, k = 1; i < breakpoints.size(); ++i) {
    if (count[i] * (1 + 1e-9) < static_cast<double>(k) * count.back() / spans) continue;
    coarse.push_back(breakpoints[i]);
    k = 1 + static_cast<std::size_t>(count[i] * (1 + 1e-9) * spans / count.back());
  }
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
