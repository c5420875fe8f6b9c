#pragma once

// The least-cost path of a ladder graph with turns, the plain way: every copy of every
// configuration as a vertex, every move as an edge.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "graph/joint_metric.hpp"
#include "graph/ladder_graph.hpp"

namespace wristwise::test {

struct LadderInstance {
  std::vector<Rung> rungs;
  EdgeRules rules;
};

/// Where a joint has no limits, its copies are taken from this many turns on either side.
inline constexpr int kTurnsOfContinuous = 5;

struct LadderOptimum {
  double cost = 0;           ///< of the best path to the last rung reached
  std::size_t reached = 0;   ///< rungs
  std::size_t vertices = 0;  ///< copies included
};

class LadderOracle {
 public:
  explicit LadderOracle(const LadderInstance& instance)
      : rungs_(instance.rungs), rules_(instance.rules) {}

  LadderOptimum solve() const {
    LadderOptimum optimum;
    std::vector<Copy> before;
    for (std::size_t i = 0; i < rungs_.size(); ++i) {
      std::vector<Copy> here = usable_copies(i);
      optimum.vertices += here.size();
      if (i > 0) connect(i - 1, before, here);
      double least = kInfinity;
      for (const Copy& copy : here) least = std::min(least, copy.distance);
      if (least == kInfinity) return optimum;
      optimum.cost = least;
      optimum.reached = i + 1;
      before = std::move(here);
    }
    return optimum;
  }

  double move_cost(std::size_t i, const JointVector& from, const JointVector& to) const {
    double cost = rules_.edge_cost ? rules_.edge_cost(i, from, to) : 0;
    for (Eigen::Index j = 0; j < from.size(); ++j) {
      const double step = std::abs(to[j] - from[j]);
      cost += rules_.weight[j] * (rules_.squared ? step * step : step);
    }
    return cost;
  }

  bool move_exists(std::size_t i, const JointVector& from, const JointVector& to) const {
    for (Eigen::Index j = 0; j < from.size(); ++j) {
      if (std::abs(to[j] - from[j]) > rules_.max_step[i][j] + 1e-12) return false;
    }
    return !rules_.is_clear || rules_.is_clear(0, i, from, to);
  }

  bool is_inside(std::size_t i, const JointVector& q) const {
    for (Eigen::Index j = 0; j < rules_.period.size(); ++j) {
      if (!std::isfinite(rules_.period[j])) continue;
      if (q[j] < lower(i, j) - 1e-9 || q[j] > upper(i, j) + 1e-9) return false;
    }
    return true;
  }

  double own_cost(std::size_t i, Eigen::Index index, const JointVector& q) const {
    return rungs_[i].cost[index] + (rules_.vertex_cost ? rules_.vertex_cost(i, q) : 0);
  }

 private:
  struct Copy {
    JointVector q;
    double own = 0, distance = kInfinity;
  };

  double lower(std::size_t i, Eigen::Index j) const {
    return rungs_[i].lower.size() > 0 ? rungs_[i].lower[j] : rules_.lower[j];
  }
  double upper(std::size_t i, Eigen::Index j) const {
    return rungs_[i].upper.size() > 0 ? rungs_[i].upper[j] : rules_.upper[j];
  }

  std::vector<Copy> usable_copies(std::size_t i) const {
    std::vector<Copy> copies;
    for (Eigen::Index v = 0; v < rungs_[i].size(); ++v) {
      const JointVector q = rungs_[i].vertex(v);
      if (rules_.is_usable && !rules_.is_usable(0, i, q)) continue;
      std::vector<JointVector> turned = {q};
      for (Eigen::Index j = 0; j < rules_.period.size(); ++j) turned = turn_joint(i, j, turned);
      for (const JointVector& copy : turned) {
        const double own = own_cost(i, v, copy);
        copies.push_back({copy, own, i == 0 ? own : kInfinity});
      }
    }
    return copies;
  }

  std::vector<JointVector> turn_joint(std::size_t i, Eigen::Index j,
                                      const std::vector<JointVector>& copies) const {
    if (!std::isfinite(rules_.period[j])) return copies;
    const bool is_limited = std::isfinite(rules_.lower[j]) && std::isfinite(rules_.upper[j]);
    const int most = is_limited ? 20 : kTurnsOfContinuous;
    std::vector<JointVector> turned;
    for (const JointVector& copy : copies) {
      for (int turn = -most; turn <= most; ++turn) {
        const double value = copy[j] + turn * rules_.period[j];
        if (value < lower(i, j) - 1e-12 || value > upper(i, j) + 1e-12) continue;
        turned.push_back(copy);
        turned.back()[j] = value;
      }
    }
    return turned;
  }

  void connect(std::size_t i, const std::vector<Copy>& from, std::vector<Copy>& to) const {
    for (Copy& v : to) {
      for (const Copy& u : from) {
        const double distance = u.distance + metric_cost(u.q, v.q) + v.own;
        if (distance >= v.distance) continue;
        const double whole = u.distance + move_cost(i, u.q, v.q) + v.own;
        if (whole < v.distance && move_exists(i, u.q, v.q)) v.distance = whole;
      }
    }
  }

  double metric_cost(const JointVector& from, const JointVector& to) const {
    const auto step = (to - from).array().abs();
    return (rules_.weight.array() * (rules_.squared ? step.square().eval() : step.eval())).sum();
  }

  const std::vector<Rung>& rungs_;
  const EdgeRules& rules_;
};

inline void expect_usable_path(const LadderInstance& instance, const LadderPath& path) {
  const LadderOracle oracle(instance);
  ASSERT_EQ(path.vertices.size(), path.positions.size());
  double cost = 0;
  for (std::size_t i = 0; i < path.positions.size(); ++i) {
    const JointVector& q = path.positions[i];
    const JointVector turned = q - instance.rungs[i].vertex(path.vertices[i]);
    for (Eigen::Index j = 0; j < q.size(); ++j) {
      const bool has_copies =
          instance.rules.period.size() > 0 && std::isfinite(instance.rules.period[j]);
      const double turns = has_copies ? turned[j] / instance.rules.period[j] : turned[j];
      EXPECT_NEAR(turns, has_copies ? std::round(turns) : 0, 1e-9) << "rung " << i;
    }
    EXPECT_TRUE(oracle.is_inside(i, q)) << "rung " << i << ": " << q.transpose();
    if (instance.rules.is_usable) {
      EXPECT_TRUE(instance.rules.is_usable(0, i, q)) << "rung " << i;
    }
    cost += oracle.own_cost(i, path.vertices[i], q);
    if (i == 0) continue;
    EXPECT_TRUE(oracle.move_exists(i - 1, path.positions[i - 1], q)) << "interval " << i - 1;
    cost += oracle.move_cost(i - 1, path.positions[i - 1], q);
  }
  EXPECT_NEAR(path.cost, cost, 1e-9);
}

inline void expect_optimum(const LadderInstance& instance, const LadderPath& path) {
  const LadderOptimum optimum = LadderOracle(instance).solve();
  EXPECT_EQ(path.found, optimum.reached == instance.rungs.size());
  EXPECT_EQ(path.positions.size(), optimum.reached);
  EXPECT_NEAR(path.cost, optimum.cost, 1e-9);
  expect_usable_path(instance, path);
}

}  // namespace wristwise::test
