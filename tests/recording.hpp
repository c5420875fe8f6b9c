#pragma once

// Recordings of a motion that is known: sines in each joint, and noise.

#include <cmath>
#include <random>

#include "wristwise/trajectory.hpp"

namespace wristwise::test {

/// q_j(t) = middle_j + sweep_j sin(rate_j t + j)
struct Swing {
  JointVector middle, sweep, rate;

  JointVector at(double t, int derivative = 0) const {
    JointVector q(middle.size());
    for (int j = 0; j < q.size(); ++j) {
      const double phase = rate[j] * t + j + derivative * std::acos(0.0);
      q[j] = (derivative == 0 ? middle[j] : 0) +
             sweep[j] * std::pow(rate[j], derivative) * std::sin(phase);
    }
    return q;
  }
};

inline JointVector joint_vector(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

/// In front of a KUKA KR 5 arc, away from its limits.
inline Swing kr5_swing() {
  return {joint_vector({0, -1.2, 1.4, 0.2, 0.8, 0.1}),
          joint_vector({0.1, 0.06, 0.08, 0.15, 0.1, 0.2}),
          joint_vector({0.3, 0.22, 0.37, 0.26, 0.18, 0.43})};
}

/// Times `step` apart; with jitter between a thousandth of that and all of it.
inline std::vector<double> recording_times(std::size_t count, double step, bool jitter = false) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> exponent(-3, 0);
  std::vector<double> times = {0};
  while (times.size() < count)
    times.push_back(times.back() + (jitter ? step * std::pow(10, exponent(random)) : step));
  return times;
}

inline JointPath record(const Swing& swing, const std::vector<double>& times, double noise) {
  std::mt19937_64 random(8);
  std::normal_distribution<double> normal(0, noise > 0 ? noise : 1);
  JointPath path;
  for (const double t : times) {
    JointVector q = swing.at(t);
    if (noise > 0)
      for (double& value : q) value += normal(random);
    path.times.push_back(t);
    path.positions.push_back(q);
  }
  return path;
}

}  // namespace wristwise::test
