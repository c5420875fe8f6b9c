#include "graph/sampling_grid.hpp"

#include <algorithm>
#include <cmath>

namespace wristwise {

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kDefaultFreeStep = 10 * kPi / 180;

/// ceil, but a quotient that is whole up to round-off counts as whole.
int intervals(double width, double step) {
  return std::max(1, static_cast<int>(std::ceil(width / step - 1e-9)));
}

std::vector<double> free_samples(double step) {
  const int count = intervals(2 * kPi, step);
  std::vector<double> samples;
  samples.reserve(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k) samples.push_back(-kPi + k * 2 * kPi / count);
  return samples;
}

}  // namespace

std::vector<double> coordinate_samples(double lower, double upper, double step) {
  if (std::isinf(lower)) return free_samples(step > 0 ? step : kDefaultFreeStep);
  if (lower == upper) return {lower};
  const int count = step > 0 ? intervals(upper - lower, step) : 1;
  std::vector<double> samples;
  samples.reserve(static_cast<std::size_t>(count) + 2);
  for (int k = 0; k <= count; ++k) {
    samples.push_back(k == count ? upper : lower + k * (upper - lower) / count);
  }
  const double on_grid = 1e-9 * (upper - lower);
  for (double& sample : samples) {
    if (std::abs(sample) < on_grid) sample = 0;
  }
  if (lower < 0 && upper > 0 && std::find(samples.begin(), samples.end(), 0.0) == samples.end()) {
    samples.insert(std::upper_bound(samples.begin(), samples.end(), 0.0), 0.0);
  }
  return samples;
}

Vector6 automatic_step(const ToleranceBox& box, int samples) {
  constexpr double kFiner = 0.9;
  constexpr double kFinest = 1e-4;  // rad
  constexpr double kLever = 1;      // m
  const auto steps = [&](double angle) {
    Vector6 step = Vector6::Constant(angle);
    step.head<3>() *= kLever;
    return step;
  };
  const auto count = [&](const Vector6& step) {
    double product = 1;
    for (int k = 0; k < 6; ++k) {
      product *= static_cast<double>(
          coordinate_samples(box.lower[k], box.upper[k], step[k]).size());
    }
    return product;
  };
  double angle = kPi;
  while (angle * kFiner > kFinest && count(steps(angle * kFiner)) <= samples) angle *= kFiner;
  return steps(angle);
}

std::vector<Vector6> waypoint_grid(const ToleranceBox& box, const GraphOptions& options) {
  return sampling_grid(box, options.automatic_samples > 0
                                ? automatic_step(box, options.automatic_samples)
                                : options.step);
}

std::vector<Vector6> sampling_grid(const ToleranceBox& box, const Vector6& step) {
  std::vector<Vector6> grid = {Vector6::Zero()};
  for (int k = 0; k < 6; ++k) {
    const auto samples = coordinate_samples(box.lower[k], box.upper[k], step[k]);
    std::vector<Vector6> product;
    product.reserve(grid.size() * samples.size());
    for (const Vector6& partial : grid) {
      for (const double sample : samples) {
        product.push_back(partial);
        product.back()[k] = sample;
      }
    }
    grid = std::move(product);
  }
  return grid;
}

}  // namespace wristwise
