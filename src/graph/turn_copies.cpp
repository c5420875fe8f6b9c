#include "graph/turn_copies.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "graph/joint_metric.hpp"

namespace wristwise {

namespace {

constexpr double kLimitTolerance = 1e-12;

/// Whole turns first .. last; all of them where a limit is infinite.
struct TurnRange {
  double first = 0, last = 0;
  double count() const { return last - first + 1; }
};

bool has_copies(const EdgeRules& rules, Eigen::Index joint) {
  return rules.period.size() > 0 && rules.period[joint] < kInfinity;
}

bool is_unlimited(const EdgeRules& rules, Eigen::Index joint) {
  return std::isinf(rules.lower[joint]) || std::isinf(rules.upper[joint]);
}

TurnRange turn_range(const Rung& rung, const EdgeRules& rules, Eigen::Index joint, double value) {
  const double lower = rung.lower.size() > 0 ? rung.lower[joint] : rules.lower[joint];
  const double upper = rung.upper.size() > 0 ? rung.upper[joint] : rules.upper[joint];
  return {std::ceil((lower - kLimitTolerance - value) / rules.period[joint]),
          std::floor((upper + kLimitTolerance - value) / rules.period[joint])};
}

/// All combinations of the copies of each joint.
void append_copies(const Rung& rung, const EdgeRules& rules, JointVector q, Eigen::Index joint,
                   std::vector<JointVector>& copies) {
  if (joint == q.size()) {
    copies.push_back(q);
    return;
  }
  if (!has_copies(rules, joint) || is_unlimited(rules, joint)) {
    return append_copies(rung, rules, q, joint + 1, copies);
  }
  const double value = q[joint];
  const TurnRange range = turn_range(rung, rules, joint, value);
  const auto count = static_cast<std::int64_t>(range.count());
  for (std::int64_t k = 0; k < count; ++k) {
    q[joint] = value + (range.first + static_cast<double>(k)) * rules.period[joint];
    append_copies(rung, rules, q, joint + 1, copies);
  }
}

}  // namespace

std::size_t copy_count(const Rung& rung, const EdgeRules& rules, Eigen::Index index) {
  double count = 1;
  for (Eigen::Index j = 0; j < rules.period.size(); ++j) {
    if (!has_copies(rules, j) || is_unlimited(rules, j)) continue;
    count *= std::max(0.0, turn_range(rung, rules, j, rung.positions(index, j)).count());
  }
  return static_cast<std::size_t>(count);
}

TurnCopies expand_turns(const std::vector<Rung>& rungs, const EdgeRules& rules) {
  TurnCopies result;
  const Eigen::Index joints = rungs.front().positions.cols();
  result.period = JointVector::Constant(joints, kInfinity);
  for (Eigen::Index j = 0; j < rules.period.size(); ++j) {
    if (has_copies(rules, j) && is_unlimited(rules, j)) result.period[j] = rules.period[j];
  }
  for (const Rung& rung : rungs) {
    std::vector<JointVector> copies;
    std::vector<Eigen::Index>& original = result.original.emplace_back();
    for (Eigen::Index v = 0; v < rung.size(); ++v) {
      append_copies(rung, rules, rung.vertex(v), 0, copies);
      original.resize(copies.size(), v);
    }
    Rung& expanded = result.rungs.emplace_back();
    expanded.lower = rung.lower;
    expanded.upper = rung.upper;
    const auto count = static_cast<Eigen::Index>(copies.size());
    expanded.positions.resize(count, joints);
    expanded.cost.resize(count);
    for (Eigen::Index k = 0; k < count; ++k) {
      expanded.positions.row(k) = copies[static_cast<std::size_t>(k)].transpose().array();
      expanded.cost[k] = rung.cost[original[static_cast<std::size_t>(k)]];
    }
  }
  return result;
}

std::optional<std::vector<JointVector>> lift_turns(const std::vector<Rung>& rungs,
                                                   const EdgeRules& rules,
                                                   const std::vector<Eigen::Index>& vertices,
                                                   const JointVector& period) {
  std::vector<JointVector> path;
  JointVector turns = JointVector::Zero(period.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    JointVector q = rungs[i].vertex(vertices[i]);
    for (Eigen::Index j = 0; i > 0 && j < q.size(); ++j) {
      if (period[j] == kInfinity) continue;
      // Not from the path so far: half a turn must go the way round that the search has checked.
      const double back = rungs[i - 1].positions(vertices[i - 1], j) - q[j];
      turns[j] += std::round(back / period[j]);
      q[j] += period[j] * turns[j];
    }
    path.push_back(q);
  }
  for (Eigen::Index j = 0; j < period.size(); ++j) {
    if (period[j] == kInfinity) continue;
    double first = -kInfinity, last = kInfinity, lowest = kInfinity, highest = -kInfinity;
    for (std::size_t i = 0; i < path.size(); ++i) {
      const double value = path[i][j];
      const TurnRange range = turn_range(rungs[i], rules, j, value);
      first = std::max(first, range.first);
      last = std::min(last, range.last);
      lowest = std::min(lowest, value);
      highest = std::max(highest, value);
    }
    if (first > last) return std::nullopt;
    double shift = 0;
    if (std::isfinite(first) && std::isfinite(last)) {
      // The middle of the path nearest to the middle of the limits; the lower one among equals.
      const double middle = (rules.lower[j] + rules.upper[j] - lowest - highest) / 2;
      const double best = std::ceil(middle / period[j] - 0.5);
      shift = std::isfinite(best) ? std::clamp(best, first, last) : first;
    } else {
      shift = std::clamp(0.0, first, last);
    }
    for (JointVector& q : path) q[j] += shift * period[j];
  }
  return path;
}

}  // namespace wristwise
