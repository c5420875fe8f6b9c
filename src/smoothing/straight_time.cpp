#include "smoothing/straight_time.hpp"

#include <algorithm>

#include "task/pose_difference.hpp"

namespace wristwise {

namespace {

constexpr double kShare = 0.9;  ///< of the stretches that have to be nearly straight
constexpr std::size_t kMostMiddles = 2000;
constexpr double kFewestSteps = 2.5;
constexpr double kShorter = 0.84089641525371454;  ///< 2^(-1/4)

double median_step(const std::vector<double>& times) {
  std::vector<double> steps;
  for (std::size_t i = 0; i + 1 < times.size(); ++i) steps.push_back(times[i + 1] - times[i]);
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

std::size_t nearest(const std::vector<double>& times, double t) {
  const auto after = std::lower_bound(times.begin() + 1, times.end() - 1, t);
  const auto i = static_cast<std::size_t>(after - times.begin());
  return t - times[i - 1] < times[i] - t ? i - 1 : i;
}

Pose between(const Pose& from, const Pose& to, double fraction) {
  Pose pose = Pose::Identity();
  pose.linear() = Eigen::Quaterniond(from.linear())
                      .slerp(fraction, Eigen::Quaterniond(to.linear()))
                      .toRotationMatrix();
  pose.translation() = (1 - fraction) * from.translation() + fraction * to.translation();
  return pose;
}

/// Whether most stretches of this length are nearly straight.
bool is_straight_over(double length, const std::vector<double>& times,
                      const std::vector<Pose>& poses, double position, double angle) {
  const std::size_t stride = (times.size() + kMostMiddles - 1) / kMostMiddles;
  double straight = 0, all = 0;
  for (std::size_t i = 0; i < times.size(); i += stride) {
    const std::size_t first = nearest(times, times[i] - 0.5 * length);
    const std::size_t last = nearest(times, times[i] + 0.5 * length);
    if (first >= i || last <= i) continue;
    const double fraction = (times[i] - times[first]) / (times[last] - times[first]);
    all += 1;
    if (is_near(poses[i], between(poses[first], poses[last], fraction), position, angle))
      straight += 1;
  }
  return straight >= kShare * all;
}

}  // namespace

StraightTime straight_time(const std::vector<double>& times, const std::vector<Pose>& poses,
                           double position, double angle) {
  const double longest = 0.25 * (times.back() - times.front());
  const double shortest = std::min(kFewestSteps * median_step(times), longest);
  for (double length = longest;; length = std::max(kShorter * length, shortest)) {
    const bool straight = is_straight_over(length, times, poses, position, angle);
    if (straight || length <= shortest) return {length, straight};
  }
}

}  // namespace wristwise
