#include "timing/slowed_stretches.hpp"

#include <algorithm>

namespace wristwise {

namespace {

constexpr double kFullSpeed = 0.999;
constexpr int kSamples = 100;  // of a stretch

/// The joint whose rates are, on average, the largest shares of their limits.
int busiest_joint(const SlowedStretch& stretch, const Trajectory& motion, const Rates& limits) {
  JointVector sum = JointVector::Zero(limits.rows());
  for (int i = 0; i < kSamples; ++i) {
    const double t = stretch.from + (stretch.to - stretch.from) * (i + 0.5) / kSamples;
    sum += rates_at(motion, t).cwiseAbs().cwiseQuotient(limits).rowwise().maxCoeff();
  }
  int joint = 0;
  sum.maxCoeff(&joint);
  return joint;
}

}  // namespace

std::vector<SlowedStretch> slowed_stretches(const Trajectory& law, const Trajectory& motion,
                                            const Rates& limits) {
  std::vector<SlowedStretch> stretches;
  bool slowed_before = false;
  for (std::size_t i = 0; i + 1 < law.times().size(); ++i) {
    JointVector least, largest;
    law.extremes(i, 1, least, largest);
    const bool slowed = least[0] < kFullSpeed;
    if (slowed && !slowed_before) stretches.push_back({law.times()[i], 0, 1, -1});
    if (slowed) {
      stretches.back().to = law.times()[i + 1];
      stretches.back().least_ratio = std::min(stretches.back().least_ratio, least[0]);
    }
    slowed_before = slowed;
  }
  for (SlowedStretch& stretch : stretches) stretch.joint = busiest_joint(stretch, motion, limits);
  return stretches;
}

}  // namespace wristwise
