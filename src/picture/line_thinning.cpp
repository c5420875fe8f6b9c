#include "picture/line_thinning.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace wristwise {

namespace {

constexpr double kInvisible = 0.1;  // px

/// The first, lowest, highest and last point of each column.
std::vector<SvgPoint> extremes_of_columns(const std::vector<SvgPoint>& line, double column) {
  std::vector<SvgPoint> kept;
  for (std::size_t begin = 0; begin < line.size();) {
    const double number = std::floor(line[begin].x / column);
    std::array<std::size_t, 4> chosen{begin, begin, begin, begin};
    std::size_t end = begin;
    for (; end < line.size() && std::floor(line[end].x / column) == number; ++end) {
      if (line[end].y < line[chosen[1]].y) chosen[1] = end;
      if (line[end].y > line[chosen[2]].y) chosen[2] = end;
      chosen[3] = end;
    }
    std::sort(chosen.begin(), chosen.end());
    const auto last = std::unique(chosen.begin(), chosen.end());
    for (auto i = chosen.begin(); i != last; ++i) kept.push_back(line[*i]);
    begin = end;
  }
  return kept;
}

double height_off(const SvgPoint& point, const SvgPoint& from, const SvgPoint& to) {
  const double share = to.x > from.x ? (point.x - from.x) / (to.x - from.x) : 0;
  // Above one another: off by what is beyond both.
  if (!(to.x > from.x)) {
    const auto [low, high] = std::minmax(from.y, to.y);
    return std::max({0.0, low - point.y, point.y - high});
  }
  return std::abs(from.y + share * (to.y - from.y) - point.y);
}

/// Douglas and Peucker's, with heights for distances.
std::vector<SvgPoint> without_points_on_lines(const std::vector<SvgPoint>& line) {
  if (line.size() < 3) return line;
  std::vector<bool> stays(line.size(), false);
  stays.front() = stays.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> spans{{0, line.size() - 1}};
  while (!spans.empty()) {
    const auto [from, to] = spans.back();
    spans.pop_back();
    double most = kInvisible;
    std::size_t farthest = from;
    for (std::size_t i = from + 1; i < to; ++i) {
      const double off = height_off(line[i], line[from], line[to]);
      if (off > most) most = off, farthest = i;
    }
    if (farthest == from) continue;
    stays[farthest] = true;
    spans.emplace_back(from, farthest);
    spans.emplace_back(farthest, to);
  }
  std::vector<SvgPoint> kept;
  for (std::size_t i = 0; i < line.size(); ++i)
    if (stays[i]) kept.push_back(line[i]);
  return kept;
}

}  // namespace

std::vector<SvgPoint> thinned(const std::vector<SvgPoint>& line, double column) {
  return without_points_on_lines(extremes_of_columns(line, column));
}

}  // namespace wristwise
