#include "graph/sampling_grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "wristwise/error.hpp"

namespace wristwise {

namespace {

constexpr double kMostSamples = 1e6;  // of a waypoint
constexpr double kPi = 3.14159265358979323846;
constexpr double kDefaultFreeStep = 10 * kPi / 180;

/// ceil, but a quotient that is whole up to round-off counts as whole.
int intervals(double width, double step) {
  const double count = std::ceil(width / step - 1e-9);
  if (!(count <= kMostSamples)) {
    throw InvalidInput("graph.samples",
                       fmt::format("a step of {:g} makes {:.3g} samples", step, count),
                       "at most a million at a waypoint");
  }
  return std::max(1, static_cast<int>(count));
}

std::vector<double> free_samples(double step) {
  const int count = intervals(2 * kPi, step);
  std::vector<double> samples;
  samples.reserve(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k) samples.push_back(-kPi + k * 2 * kPi / count);
  return samples;
}

/// Every point of the grid with every sample of one coordinate.
template <class Point>
void multiply(std::vector<Point>& grid, Eigen::Index coordinate,
              const std::vector<double>& samples) {
  std::vector<Point> product;
  product.reserve(grid.size() * samples.size());
  for (const Point& partial : grid) {
    for (const double sample : samples) {
      product.push_back(partial);
      product.back()[coordinate] = sample;
    }
  }
  grid = std::move(product);
}

void check_joint_steps(const std::vector<double>& step, Eigen::Index joints) {
  if (!step.empty() && static_cast<Eigen::Index>(step.size()) != joints)
    throw InvalidInput("graph.samples.joints", fmt::format("{} steps", step.size()),
                       fmt::format("one per joint, {}, or none", joints));
  for (const double value : step) {
    if (!(value >= 0))
      throw InvalidInput("graph.samples.joints", fmt::format("{} is no step", value),
                         "0 or more, rad or m");
  }
}

/// Both ends and the middle are exactly those of the range.
std::vector<double> joint_samples(double lower, double upper, double nominal, double step) {
  if (lower == upper) return {lower};
  std::vector<double> samples = coordinate_samples(lower - nominal, upper - nominal, step);
  for (double& sample : samples) sample += nominal;
  samples.front() = lower;
  samples.back() = upper;
  return samples;
}

/// Checked before the samples are made: a small step would fill the memory.
void check_grid_size(const JointBox& box, const std::vector<double>& step) {
  double count = 1;
  for (Eigen::Index j = 0; j < box.lower.size(); ++j) {
    const double s = step.empty() ? 0 : step[static_cast<std::size_t>(j)];
    const double width = box.upper[j] - box.lower[j];
    if (width > 0) count *= s > 0 ? width / s + 1 : 3;
  }
  if (!(count <= kMostSamples))
    throw InvalidInput("graph.samples.joints",
                       fmt::format("a joint waypoint has about {:.3g} samples", count),
                       "at most a million: larger steps, or ranges for fewer joints");
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
      product *=
          static_cast<double>(coordinate_samples(box.lower[k], box.upper[k], step[k]).size());
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
    if (static_cast<double>(grid.size()) * static_cast<double>(samples.size()) > kMostSamples) {
      throw InvalidInput("graph.samples", "the steps together make too many samples",
                         "at most a million at a waypoint");
    }
    multiply(grid, k, samples);
  }
  return grid;
}

std::vector<JointVector> joint_grid(const JointBox& box, const std::vector<double>& step) {
  const Eigen::Index joints = box.lower.size();
  check_joint_steps(step, joints);
  check_grid_size(box, step);
  const JointVector nominal = box.nominal();
  std::vector<JointVector> grid = {nominal};
  for (Eigen::Index j = 0; j < joints; ++j) {
    const double s = step.empty() ? 0 : step[static_cast<std::size_t>(j)];
    multiply(grid, j, joint_samples(box.lower[j], box.upper[j], nominal[j], s));
  }
  return grid;
}

}  // namespace wristwise
