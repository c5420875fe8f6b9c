#include "timing/uniform_speed.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace wristwise {

namespace {

/// Where in a piece joint `j` has its largest |q^(k)|.
double time_of_largest(const Trajectory& motion, std::size_t piece, int derivative, int j) {
  constexpr int kSamples = 64;
  constexpr double kInside = 1e-9;  // of the piece: its own jerk, not the next one's
  const double t0 = motion.times()[piece], t1 = motion.times()[piece + 1];
  double time = t0, largest = 0;
  for (int i = 0; i <= kSamples; ++i) {
    const double share = std::clamp(static_cast<double>(i) / kSamples, kInside, 1 - kInside);
    const double t = t0 + (t1 - t0) * share;
    const double value = std::abs(motion.evaluate(t, derivative)[j]);
    if (value > largest) {
      largest = value;
      time = t;
    }
  }
  return time;
}

}  // namespace

UniformSlowdown uniform_slowdown(const Trajectory& motion, const Rates& limits) {
  UniformSlowdown most;
  std::size_t most_piece = 0;
  for (std::size_t i = 0; i + 1 < motion.times().size(); ++i) {
    for (int k = 1; k <= 3; ++k) {
      JointVector least, largest;
      motion.extremes(i, k, least, largest);
      for (int j = 0; j < static_cast<int>(limits.rows()); ++j) {
        const double ratio = std::max(largest[j], -least[j]) / limits(j, k - 1);
        const double factor = std::pow(ratio, 1.0 / k);
        if (factor <= most.factor) continue;
        most = {factor, ratio, j, k, 0};
        most_piece = i;
      }
    }
  }
  if (most.joint >= 0) most.time = time_of_largest(motion, most_piece, most.derivative, most.joint);
  return most;
}

Trajectory stretched(const Trajectory& motion, double factor) {
  std::vector<double> times = motion.times();
  std::vector<JointVector> velocities = motion.velocities(), accelerations = motion.accelerations();
  for (double& t : times) t = motion.times().front() + factor * (t - motion.times().front());
  for (JointVector& v : velocities) v /= factor;
  for (JointVector& a : accelerations) a /= factor * factor;
  return {std::move(times), motion.positions(), std::move(velocities), std::move(accelerations)};
}

}  // namespace wristwise
