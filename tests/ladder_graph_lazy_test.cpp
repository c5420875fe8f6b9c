#include <gtest/gtest.h>

#include <atomic>
#include <map>
#include <mutex>
#include <tuple>

#include "graph/ladder_graph.hpp"
#include "ladder_oracle.hpp"
#include "random_ladder.hpp"

namespace wristwise {
namespace {

using namespace test;

LadderInstance random_instance(unsigned seed, int rungs, int smallest, int largest, int joints) {
  LadderDice dice(seed);
  LadderInstance instance{seed % 2 == 0 ? dice.drifting_rungs(rungs, largest, joints, -0.02, 0.08)
                                        : dice.unrelated_rungs(rungs, smallest, largest, joints),
                          dice.rules(rungs, joints)};
  instance.rules.squared = seed % 5 == 4;
  return instance;
}

void leave_one_copy(LadderInstance& instance) {
  instance.rules.lower.setConstant(-kTurn / 2);
  instance.rules.upper.setConstant(kTurn / 2);
}

/// What cannot be used is taken out before the search.
LadderInstance without_unusable(const LadderInstance& instance) {
  LadderInstance left = instance;
  left.rules.is_usable = nullptr;
  for (std::size_t i = 0; i < left.rungs.size(); ++i) {
    const Rung& all = instance.rungs[i];
    Eigen::Index count = 0;
    for (Eigen::Index v = 0; v < all.size(); ++v) {
      if (!instance.rules.is_usable(0, i, all.vertex(v))) continue;
      left.rungs[i].positions.row(count) = all.positions.row(v);
      left.rungs[i].cost[count++] = all.cost[v];
    }
    left.rungs[i].positions.conservativeResize(count, Eigen::NoChange);
    left.rungs[i].cost.conservativeResize(count);
  }
  return left;
}

bool has_empty_rung(const LadderInstance& instance) {
  for (const Rung& rung : instance.rungs) {
    if (rung.size() == 0) return true;
  }
  return false;
}

/// Counts what is asked, and how often the same.
struct Questions {
  std::mutex mutex;
  std::map<std::pair<std::size_t, std::vector<std::int64_t>>, int> asked;
  std::map<std::tuple<std::size_t, std::vector<std::int64_t>, std::vector<std::int64_t>>, int>
      moves;
};

std::vector<std::int64_t> rounded(const JointVector& q) {
  std::vector<std::int64_t> result;
  for (const double value : q) result.push_back(std::llround(1e7 * value));
  return result;
}

JointVector without_turns(const EdgeRules& rules, JointVector q) {
  for (Eigen::Index j = 0; j < q.size(); ++j) q[j] = principal(rules, q, j);
  return q;
}

/// The same checks, each of them recorded.
LadderInstance recorded(const LadderInstance& instance, Questions& questions) {
  LadderInstance result = instance;
  if (instance.rules.is_usable) {
    result.rules.is_usable = [&questions, check = instance.rules.is_usable](
                                 int worker, std::size_t i, const JointVector& q) {
      const std::lock_guard<std::mutex> lock(questions.mutex);
      ++questions.asked[{i, rounded(q)}];
      return check(worker, i, q);
    };
  }
  if (instance.rules.is_clear) {
    result.rules.is_clear = [&questions, turns = instance.rules, check = instance.rules.is_clear](
                                int worker, std::size_t i, const JointVector& from,
                                const JointVector& to) {
      const std::lock_guard<std::mutex> lock(questions.mutex);
      const JointVector start = without_turns(turns, from);
      ++questions.moves[{i, rounded(start), rounded(to - from + start)}];
      return check(worker, i, from, to);
    };
  }
  return result;
}

TEST(LazyChecks, OfConfigurationsGiveTheOptimum) {
  int infeasible = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    LadderInstance instance = random_instance(seed, 6, 1, 15, 1 + static_cast<int>(seed % 2));
    block_configurations(instance.rules, seed, 0.05 * static_cast<double>(seed % 20));
    if (seed % 3 == 0) block_moves(instance.rules, seed, 0.3);
    const LadderPath path = solve(instance);
    expect_optimum(instance, path);
    infeasible += !path.found;
    if (HasFailure()) return;
  }
  EXPECT_GT(infeasible, 10);
  EXPECT_LT(infeasible, 150);
}

TEST(LazyChecks, OfConfigurationsCostLessThanEagerOnes) {
  for (unsigned seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    LadderInstance instance = random_instance(1000 + seed, 8, 40, 40, 2);
    block_configurations(instance.rules, seed, 0.05 * static_cast<double>(seed % 20));
    const LadderInstance left = without_unusable(instance);
    if (has_empty_rung(left)) continue;
    Questions questions;
    const LadderPath lazy = solve(recorded(instance, questions));
    EXPECT_NEAR(lazy.cost, solve(left).cost, 1e-9);
    EXPECT_EQ(lazy.statistics.usable_checks, questions.asked.size());
    for (const auto& [question, times] : questions.asked) EXPECT_EQ(times, 1);
    EXPECT_LE(lazy.statistics.usable_checks, 8U * 40U);
    if (seed % 20 == 0) {  // nothing is blocked
      EXPECT_EQ(lazy.statistics.usable_checks, 8U);
    }
    if (HasFailure()) return;
  }
}

/// A move and its copies, both ends shifted by the same turns, are asked about once.
TEST(LazyChecks, OfMovesAreNotRepeated) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    LadderInstance instance = random_instance(2000 + seed, 5, 20, 20, 2);
    instance.rules.lower.setConstant(-500 * kDegree);
    instance.rules.upper.setConstant(500 * kDegree);
    block_moves(instance.rules, seed, 0.08 * static_cast<double>(seed % 12));
    Questions questions;
    const LadderPath path = solve(recorded(instance, questions), 4);
    std::size_t asked = 0;
    for (const auto& [question, times] : questions.moves) {
      EXPECT_EQ(times, 1);
      asked += static_cast<std::size_t>(times);
    }
    EXPECT_EQ(path.statistics.clear_checks, asked);
  }
}

TEST(LazyChecks, OfTheOnlyRung) {
  LadderDice dice(1);
  LadderInstance instance{dice.unrelated_rungs(1, 20, 20, 2), dice.rules(1, 2)};
  for (const double share : {0.0, 0.5, 1.0}) {
    block_configurations(instance.rules, 7, share);
    expect_optimum(instance, solve(instance));
  }
}

TEST(LazyChecks, WithABlockedRungGiveThePartBefore) {
  for (std::size_t blocked = 0; blocked < 5; ++blocked) {
    LadderInstance instance = random_instance(11, 5, 10, 10, 2);
    instance.rules.is_usable = [blocked](int, std::size_t i, const JointVector&) {
      return i != blocked;
    };
    const LadderPath path = solve(instance);
    EXPECT_FALSE(path.found);
    EXPECT_EQ(path.positions.size(), blocked);
    expect_optimum(instance, path);
  }
}

/// Wide enough for corridors, trees and retries.
TEST(LargeRungs, GiveTheOptimum) {
  for (unsigned seed = 0; seed < 24; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    LadderInstance instance = random_instance(3000 + seed, 6 + static_cast<int>(seed % 4), 300, 700,
                                              1 + static_cast<int>(seed % 3));
    leave_one_copy(instance);
    if (seed % 3 == 1) block_configurations(instance.rules, seed, 0.6);
    if (seed % 4 >= 2) block_moves(instance.rules, seed, 0.3);
    if (seed % 6 == 5) {
      for (JointVector& step : instance.rules.max_step) step.setConstant(0.1);
    }
    const LadderPath path = solve(instance);
    expect_optimum(instance, path);
    if (HasFailure()) return;
  }
}

TEST(LargeRungs, WithTurnsGiveTheOptimum) {
  for (unsigned seed = 0; seed < 10; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    LadderInstance instance = random_instance(4000 + seed, 6, 300, 500, 2);
    instance.rules.period[1] = kInfinity;
    if (seed % 3 == 1) block_configurations(instance.rules, seed, 0.9);
    if (seed % 3 == 2) {
      instance.rules.vertex_cost = [](std::size_t, const JointVector& q) {
        return 0.05 * (1 + std::sin(q[0] / 4));
      };
    }
    if (seed % 4 == 3) block_moves(instance.rules, seed, 0.5);
    expect_optimum(instance, solve(instance));
    if (HasFailure()) return;
  }
}

TEST(LargeRungs, LookAtFewEdgesAlongASeam) {
  LadderDice dice(5);
  LadderInstance instance{dice.drifting_rungs(40, 1500, 3, -0.01, 0.04), dice.rules(40, 3)};
  const LadderPath path = solve(instance);
  EXPECT_TRUE(path.found);
  EXPECT_LT(path.statistics.edges_evaluated, 0.1 * 39 * 1500 * 1500);
  expect_usable_path(instance, path);
}

TEST(LargeRungs, WithCostsBelowZeroGiveTheOptimum) {
  for (unsigned seed = 0; seed < 8; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    LadderInstance instance = random_instance(5000 + seed, 6, 300, 400, 2);
    leave_one_copy(instance);
    for (Rung& rung : instance.rungs) rung.cost = 10 * rung.cost - 20;
    expect_optimum(instance, solve(instance));
    if (HasFailure()) return;
  }
}

void expect_same(const LadderPath& one, const LadderPath& other) {
  EXPECT_EQ(one.found, other.found);
  EXPECT_EQ(one.vertices, other.vertices);
  EXPECT_EQ(one.positions, other.positions);
  EXPECT_EQ(one.cost, other.cost);
  EXPECT_EQ(one.statistics.vertices, other.statistics.vertices);
  EXPECT_EQ(one.statistics.edges, other.statistics.edges);
  EXPECT_EQ(one.statistics.edges_evaluated, other.statistics.edges_evaluated);
  EXPECT_EQ(one.statistics.usable_checks, other.statistics.usable_checks);
  EXPECT_EQ(one.statistics.clear_checks, other.statistics.clear_checks);
}

/// Coarse values, so that many paths cost exactly the same.
void make_ties(LadderInstance& instance) {
  instance.rules.period.setConstant(8);
  instance.rules.lower.setConstant(-10);
  instance.rules.upper.setConstant(10);
  instance.rules.weight.setOnes();
  for (Rung& rung : instance.rungs) {
    rung.cost.setZero();
    rung.positions = (4 * rung.positions / kTurn).round();
  }
}

TEST(LadderGraph, IsTheSameForEveryNumberOfThreads) {
  for (unsigned seed = 0; seed < 36; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const bool is_large = seed % 6 == 0;
    LadderInstance instance =
        is_large ? random_instance(seed, 8, 300, 400, 2) : random_instance(seed, 6, 20, 40, 2);
    if (seed % 2 == 0) make_ties(instance);
    if (is_large) instance.rules.period[0] = kInfinity;
    if (seed % 3 != 0) block_configurations(instance.rules, seed, 0.1 * (seed % 9));
    if (seed % 4 != 0) block_moves(instance.rules, seed, 0.1 * (seed % 7));
    if (seed % 5 == 0) {
      instance.rules.edge_cost = [](std::size_t, const JointVector&, const JointVector& to) {
        return to[0] > 2 ? 0.5 : 0.0;
      };
    }
    const LadderPath one = solve(instance, 1);
    expect_same(one, solve(instance, 2));
    expect_same(one, solve(instance, 5));
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace wristwise
