#include "graph/relaxation.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "vector_clones.hpp"

namespace wristwise {

namespace {

constexpr std::size_t kTile = 512;  // vertices whose totals stay in the first-level cache
constexpr std::size_t kLanes = 8;

struct JointRule {
  double target, weight, period, max_step;
  bool squared;
};

WRISTWISE_IN_CLONES void add_joint(const double* q, std::size_t size, const JointRule& rule,
                                   double* sum) {
  const double target = rule.target, weight = rule.weight, period = rule.period;
  if (rule.max_step == kInfinity && period == kInfinity && !rule.squared) {
    for (std::size_t u = 0; u < size; ++u) sum[u] += weight * std::fabs(q[u] - target);
    return;
  }
  const double limit = rule.max_step;
  for (std::size_t u = 0; u < size; ++u) {
    const double straight = std::fabs(q[u] - target);
    const double step = period - straight < straight ? period - straight : straight;
    const double cost = weight * (rule.squared ? step * step : step);
    sum[u] = step > limit ? kInfinity : sum[u] + cost;
  }
}

WRISTWISE_VECTOR_CLONES
double relax(const RungColumns& from, const double* distance, const JointRule* rules, int joints,
             double* total) {
  std::array<double, kLanes> least{};
  least.fill(kInfinity);
  for (std::size_t begin = 0; begin < from.count; begin += kTile) {
    const std::size_t size = std::min(kTile, from.count - begin);
    double* const sum = total + begin;
    std::copy_n(distance + begin, size, sum);
    for (int j = 0; j < joints; ++j) {
      add_joint(from.positions + static_cast<std::size_t>(j) * from.count + begin, size, rules[j],
                sum);
    }
    std::size_t u = 0;
    for (; u + kLanes <= size; u += kLanes) {
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        least[lane] = sum[u + lane] < least[lane] ? sum[u + lane] : least[lane];
      }
    }
    for (; u < size; ++u) least[0] = std::min(least[0], sum[u]);
  }
  return *std::min_element(least.begin(), least.end());
}

}  // namespace

double relax_towards(const RungColumns& from, const double* distance, const double* target,
                     const JointMetric& metric, const double* max_step, double* total) {
  std::array<JointRule, kMaxJoints> rules{};
  for (int j = 0; j < metric.joints(); ++j) {
    rules[static_cast<std::size_t>(j)] = {target[j], metric.weight[j], metric.period[j],
                                          max_step[j], metric.squared};
  }
  return relax(from, distance, rules.data(), metric.joints(), total);
}

}  // namespace wristwise
