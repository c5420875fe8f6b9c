#include "graph/turn_copies.hpp"

#include <gtest/gtest.h>

#include "random_ladder.hpp"

namespace wristwise {
namespace {

using namespace test;

constexpr int kManyTurns = 12;

/// Two or three joints: one between limits, one of any kind, one without copies.
LadderInstance random_instance(unsigned seed, bool continuous) {
  LadderDice dice(seed);
  const int joints = dice.integer(2, 3);
  LadderInstance instance{dice.unrelated_rungs(dice.integer(1, 8), 1, 5, joints),
                          dice.rules(8, joints)};
  instance.rules.lower[0] = dice.uniform(-12, -kTurn / 2);
  instance.rules.upper[0] = dice.uniform(kTurn / 2, 12);
  if (continuous) {
    instance.rules.lower[1] = -kInfinity;
    instance.rules.upper[1] = kInfinity;
  }
  if (joints == 3) instance.rules.period[2] = kInfinity;
  return instance;
}

bool is_within(double value, double lower, double upper) {
  return value >= lower && value <= upper;
}

/// Whole turns of a joint that keep it between its limits.
std::vector<int> turns_inside(const LadderInstance& instance, std::size_t i, Eigen::Index v,
                              Eigen::Index j) {
  const Rung& rung = instance.rungs[i];
  const EdgeRules& rules = instance.rules;
  if (std::isinf(rules.period[j]) || std::isinf(rules.lower[j])) return {0};
  const double lower = rung.lower.size() > 0 ? rung.lower[j] : rules.lower[j];
  const double upper = rung.upper.size() > 0 ? rung.upper[j] : rules.upper[j];
  std::vector<int> turns;
  for (int turn = -kManyTurns; turn <= kManyTurns; ++turn) {
    const double value = rung.positions(v, j) + turn * rules.period[j];
    if (is_within(value, lower, upper)) turns.push_back(turn);
  }
  return turns;
}

std::vector<JointVector> all_copies(const LadderInstance& instance, std::size_t i, Eigen::Index v) {
  std::vector<JointVector> copies = {instance.rungs[i].vertex(v)};
  for (Eigen::Index j = 0; j < copies[0].size(); ++j) {
    std::vector<JointVector> turned;
    for (const JointVector& copy : copies) {
      for (const int turn : turns_inside(instance, i, v, j)) {
        turned.push_back(copy);
        if (turn != 0) turned.back()[j] += turn * instance.rules.period[j];
      }
    }
    copies = turned;
  }
  return copies;
}

void limit_a_rung(LadderInstance& instance, LadderDice& dice) {
  Rung& rung = instance.rungs.back();
  rung.lower = instance.rules.lower;
  rung.upper = instance.rules.upper;
  rung.lower[0] = dice.uniform(rung.lower[0], rung.upper[0] - kTurn);
}

TEST(TurnCopies, AreEveryCopyBetweenTheLimits) {
  for (unsigned seed = 0; seed < 100; ++seed) {
    LadderInstance instance = random_instance(seed, seed % 2 == 0);
    LadderDice dice(seed);
    if (seed % 3 == 0) limit_a_rung(instance, dice);
    const TurnCopies copies = expand_turns(instance.rungs, instance.rules);
    ASSERT_EQ(copies.rungs.size(), instance.rungs.size());
    for (std::size_t i = 0; i < instance.rungs.size(); ++i) {
      Eigen::Index at = 0;
      for (Eigen::Index v = 0; v < instance.rungs[i].size(); ++v) {
        const std::vector<JointVector> expected = all_copies(instance, i, v);
        EXPECT_EQ(copy_count(instance.rungs[i], instance.rules, v), expected.size());
        for (const JointVector& copy : expected) {
          ASSERT_LT(at, copies.rungs[i].size());
          EXPECT_EQ(copies.original[i][static_cast<std::size_t>(at)], v);
          EXPECT_EQ(copies.rungs[i].cost[at], instance.rungs[i].cost[v]);
          EXPECT_LT((copies.rungs[i].vertex(at) - copy).norm(), 1e-12);
          ++at;
        }
      }
      EXPECT_EQ(at, copies.rungs[i].size());
    }
  }
}

TEST(TurnCopies, LeaveAJointWithoutLimitsToTheMetric) {
  const LadderInstance instance = random_instance(1, true);
  const TurnCopies copies = expand_turns(instance.rungs, instance.rules);
  EXPECT_EQ(copies.period[0], kInfinity);
  EXPECT_EQ(copies.period[1], kTurn);
}

TEST(TurnCopies, OfNoJointAreTheConfigurations) {
  LadderInstance instance = random_instance(2, false);
  instance.rules.period = instance.rules.lower = instance.rules.upper = JointVector();
  const TurnCopies copies = expand_turns(instance.rungs, instance.rules);
  for (std::size_t i = 0; i < instance.rungs.size(); ++i) {
    EXPECT_TRUE((copies.rungs[i].positions == instance.rungs[i].positions).all());
    EXPECT_EQ(copy_count(instance.rungs[i], instance.rules, 0), 1U);
  }
}

/// A limit that is met but for round-off.
TEST(TurnCopies, IncludeACopyOnTheLimit) {
  LadderInstance instance = random_instance(3, false);
  instance.rungs[0].positions(0, 0) = -350 * kDegree + kTurn;
  instance.rules.lower[0] = -350 * kDegree;
  instance.rules.upper[0] = 350 * kDegree;
  instance.rungs[0].positions(0, 1) = 350 * kDegree - kTurn;
  instance.rules.lower[1] = -350 * kDegree;
  instance.rules.upper[1] = 350 * kDegree;
  EXPECT_EQ(copy_count(instance.rungs[0], instance.rules, 0), 4U);
}

std::vector<Eigen::Index> random_path(const LadderInstance& instance, LadderDice& dice) {
  std::vector<Eigen::Index> path;
  for (const Rung& rung : instance.rungs) {
    path.push_back(dice.integer(0, static_cast<int>(rung.size()) - 1));
  }
  return path;
}

/// Of one joint, going the shorter way round.
std::vector<double> unwrapped(const LadderInstance& instance, const std::vector<Eigen::Index>& path,
                              Eigen::Index j) {
  std::vector<double> values = {instance.rungs[0].positions(path[0], j)};
  for (std::size_t i = 1; i < path.size(); ++i) {
    const double straight =
        instance.rungs[i].positions(path[i], j) - instance.rungs[i - 1].positions(path[i - 1], j);
    values.push_back(values.back() + std::remainder(straight, instance.rules.period[j]));
  }
  return values;
}

/// How far from the joint's limits the path stays with so many turns; below 0 where it leaves them
/// or those of a rung.
double room(const LadderInstance& instance, const std::vector<double>& values, int turn,
            Eigen::Index j) {
  double least = kInfinity;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double value = values[i] + turn * instance.rules.period[j];
    const Rung& rung = instance.rungs[i];
    if (rung.lower.size() > 0 && !is_within(value, rung.lower[j], rung.upper[j])) return -1;
    least = std::min({least, value - instance.rules.lower[j], instance.rules.upper[j] - value});
  }
  return least;
}

TEST(TurnCopies, LiftAPathAsFarFromTheLimitsAsPossible) {
  int none = 0;
  for (unsigned seed = 0; seed < 400; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    LadderInstance instance = random_instance(seed, false);
    LadderDice dice(seed);
    if (seed % 3 == 0) limit_a_rung(instance, dice);
    const std::vector<Eigen::Index> path = random_path(instance, dice);
    const auto lifted = lift_turns(instance.rungs, instance.rules, path, instance.rules.period);
    for (Eigen::Index j = 0; j < instance.rules.period.size(); ++j) {
      if (std::isinf(instance.rules.period[j])) continue;
      const std::vector<double> values = unwrapped(instance, path, j);
      double best = -1;
      for (int turn = -kManyTurns; turn <= kManyTurns; ++turn) {
        best = std::max(best, room(instance, values, turn, j));
      }
      if (!lifted) {
        none += best < 0;
        continue;
      }
      std::vector<double> found;
      for (const JointVector& q : *lifted) found.push_back(q[j]);
      EXPECT_NEAR(room(instance, found, 0, j), best, 1e-9);
      for (std::size_t i = 0; i < found.size(); ++i) {
        EXPECT_NEAR(found[i] - found[0], values[i] - values[0], 1e-9);
        const double turns = (found[i] - instance.rungs[i].positions(path[i], j)) / kTurn;
        EXPECT_NEAR(turns, std::round(turns), 1e-9);
      }
    }
  }
  EXPECT_GT(none, 20);
}

TEST(TurnCopies, LiftNoPathOnlyWhereNoShiftFits) {
  for (unsigned seed = 0; seed < 400; ++seed) {
    LadderInstance instance = random_instance(seed, false);
    LadderDice dice(seed);
    if (seed % 3 == 0) limit_a_rung(instance, dice);
    const std::vector<Eigen::Index> path = random_path(instance, dice);
    bool fits = true;
    for (Eigen::Index j = 0; j < instance.rules.period.size(); ++j) {
      if (std::isinf(instance.rules.period[j])) continue;
      const std::vector<double> values = unwrapped(instance, path, j);
      bool any = false;
      for (int turn = -kManyTurns; turn <= kManyTurns; ++turn) {
        any = any || room(instance, values, turn, j) >= 0;
      }
      fits = fits && any;
    }
    EXPECT_EQ(lift_turns(instance.rungs, instance.rules, path, instance.rules.period).has_value(),
              fits)
        << seed;
  }
}

TEST(TurnCopies, LiftAJointWithoutLimitsFromWhereItStarts) {
  LadderInstance instance = random_instance(4, true);
  LadderDice dice(4);
  const auto path = random_path(instance, dice);
  const auto lifted = lift_turns(instance.rungs, instance.rules, path, instance.rules.period);
  if (lifted) {
    EXPECT_EQ((*lifted)[0][1], instance.rungs[0].positions(path[0], 1));
  }
  instance.rules.lower[0] = -kInfinity;
  EXPECT_TRUE(lift_turns(instance.rungs, instance.rules, path, instance.rules.period));
}

TEST(TurnCopies, LiftAnEmptyPath) {
  const LadderInstance instance = random_instance(5, true);
  const auto lifted = lift_turns(instance.rungs, instance.rules, {}, instance.rules.period);
  ASSERT_TRUE(lifted);
  EXPECT_TRUE(lifted->empty());
}

}  // namespace
}  // namespace wristwise
