#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace wristwise {

/// Into how many parts a stretch is cut, none of them longer than `spacing`.
inline int part_count(double length, double spacing) {
  return std::max(1, static_cast<int>(std::ceil(length / spacing - 1e-9)));
}

/// `times`, and between them so many more that none is farther from the next than `spacing`.
inline std::vector<double> subdivided(const std::vector<double>& times, double spacing) {
  std::vector<double> finer = {times.front()};
  for (std::size_t i = 0; i + 1 < times.size(); ++i) {
    const double step = times[i + 1] - times[i];
    const int count = part_count(step, spacing);
    for (int k = 1; k < count; ++k) finer.push_back(times[i] + step * k / count);
    finer.push_back(times[i + 1]);
  }
  return finer;
}

}  // namespace wristwise
