#include "graph/sample_cells.hpp"

#include <algorithm>

namespace wristwise {

SampleCells::SampleCells(const ToleranceBox& box, const std::vector<Vector6>& grid) : box_(box) {
  for (int k = 0; k < 6; ++k) {
    std::vector<double>& values = values_[static_cast<std::size_t>(k)];
    for (const Vector6& deviation : grid) values.push_back(deviation[k]);
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
  }
}

ToleranceSample SampleCells::sample(const Pose& path_frame, const Vector6& deviation) const {
  ToleranceSample sample{box_, path_frame, deviation, deviation, deviation};
  for (int k = 0; k < 6; ++k) {
    const std::vector<double>& values = values_[static_cast<std::size_t>(k)];
    if (values.size() < 2) continue;
    const auto here = std::lower_bound(values.begin(), values.end(), deviation[k]);
    const bool first = here == values.begin(), last = here + 1 == values.end();
    const double below = first ? *(here + 1) - *here : *here - *(here - 1);
    const double above = last ? below : *(here + 1) - *here;
    sample.lower[k] = std::max(box_.lower[k], deviation[k] - below / 2);
    sample.upper[k] = std::min(box_.upper[k], deviation[k] + above / 2);
  }
  return sample;
}

}  // namespace wristwise
