#pragma once

// Seeded ladder graphs with turns, and checks that keep the promises of EdgeRules.

#include <cmath>
#include <cstdint>
#include <random>

#include "ladder_oracle.hpp"

namespace wristwise::test {

inline constexpr double kTurn = 6.28318530717958647692;
inline constexpr double kDegree = kTurn / 360;

class LadderDice {
 public:
  explicit LadderDice(unsigned seed) : random_(seed) {}

  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  int integer(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }
  bool chance(double share) { return uniform(0, 1) < share; }

  Rung rung(int count, int joints) {
    Rung rung;
    rung.positions =
        Eigen::ArrayXXd::NullaryExpr(count, joints, [&] { return uniform(-kTurn / 2, kTurn / 2); });
    rung.cost = Eigen::ArrayXd::NullaryExpr(count, [&] { return uniform(0, 0.3); });
    return rung;
  }

  std::vector<Rung> unrelated_rungs(int rungs, int smallest, int largest, int joints) {
    std::vector<Rung> result;
    for (int i = 0; i < rungs; ++i) result.push_back(rung(integer(smallest, largest), joints));
    return result;
  }

  /// Each rung is the one before, farther on by `low` to `high` at each joint: as along a seam.
  std::vector<Rung> drifting_rungs(int rungs, int count, int joints, double low, double high) {
    std::vector<Rung> result = {rung(count, joints)};
    while (static_cast<int>(result.size()) < rungs) {
      Rung next = result.back();
      for (double& value : next.positions.reshaped()) {
        value = std::remainder(value + uniform(low, high), kTurn);
      }
      result.push_back(next);
    }
    return result;
  }

  EdgeRules rules(int rungs, int joints) {
    EdgeRules rules;
    rules.weight = JointVector::NullaryExpr(joints, [&] { return uniform(0.2, 1.5); });
    rules.max_step.assign(static_cast<std::size_t>(rungs - 1),
                          JointVector::Constant(joints, kInfinity));
    rules.period = JointVector::Constant(joints, kTurn);
    rules.lower = JointVector::Constant(joints, -350 * kDegree);
    rules.upper = JointVector::Constant(joints, 350 * kDegree);
    return rules;
  }

 private:
  std::mt19937 random_;
};

/// From 0 to 1, the same for the same numbers.
class Hash {
 public:
  explicit Hash(std::uint64_t seed) : state_(seed) {}
  Hash& add(std::int64_t number) {
    state_ = (state_ ^ static_cast<std::uint64_t>(number)) * 0x9E3779B97F4A7C15u;
    state_ ^= state_ >> 29;
    state_ *= 0xBF58476D1CE4E5B9u;
    state_ ^= state_ >> 32;
    return *this;
  }
  double value() const { return static_cast<double>(state_ >> 11) / 9007199254740992.0; }

 private:
  std::uint64_t state_;
};

/// Whole turns are taken off where the joint has copies.
inline double principal(const EdgeRules& rules, const JointVector& q, Eigen::Index j) {
  if (!std::isfinite(rules.period[j])) return q[j];
  return q[j] - rules.period[j] * std::floor(q[j] / rules.period[j] + 0.5 + 1e-9);
}

inline void add_configuration(Hash& hash, const EdgeRules& rules, const JointVector& q) {
  for (Eigen::Index j = 0; j < q.size(); ++j) hash.add(std::llround(1e7 * principal(rules, q, j)));
}

/// Blocks this share of the configurations.
inline void block_configurations(EdgeRules& rules, std::uint64_t seed, double share) {
  EdgeRules turns;
  turns.period = rules.period;
  rules.is_usable = [turns, seed, share](int, std::size_t i, const JointVector& q) {
    Hash hash(seed + i);
    add_configuration(hash, turns, q);
    return hash.value() >= share;
  };
}

/// Blocks this share of the moves, each way round on its own.
inline void block_moves(EdgeRules& rules, std::uint64_t seed, double share) {
  EdgeRules turns;
  turns.period = rules.period;
  rules.is_clear = [turns, seed, share](int, std::size_t i, const JointVector& from,
                                        const JointVector& to) {
    Hash hash(seed + i);
    add_configuration(hash, turns, from);
    add_configuration(hash, turns, to);
    for (Eigen::Index j = 0; j < from.size(); ++j) {
      const double without = principal(turns, to, j) - principal(turns, from, j);
      const double turned = to[j] - from[j] - without;
      hash.add(std::isfinite(turns.period[j]) ? std::lround(turned / turns.period[j]) : 0);
    }
    return hash.value() >= share;
  };
}

inline LadderPath solve(const LadderInstance& instance, int threads = 2) {
  return find_least_cost_path(instance.rungs, instance.rules, threads, {});
}

}  // namespace wristwise::test
