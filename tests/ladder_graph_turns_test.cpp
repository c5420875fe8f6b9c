#include <gtest/gtest.h>

#include "graph/ladder_graph.hpp"
#include "ladder_oracle.hpp"
#include "random_ladder.hpp"

namespace wristwise {
namespace {

using namespace test;

/// Two joints of which one may also be continuous, or one joint.
LadderInstance random_instance(unsigned seed) {
  LadderDice dice(seed);
  const int rungs = dice.integer(2, 8), joints = dice.integer(1, 2);
  LadderInstance instance;
  instance.rungs = seed % 3 == 0 ? dice.drifting_rungs(rungs, 12, joints, -0.2, 0.6)
                                 : dice.unrelated_rungs(rungs, 1, 12, joints);
  instance.rules = dice.rules(rungs, joints);
  instance.rules.squared = dice.chance(0.3);
  for (Eigen::Index j = 0; j < joints; ++j) {
    const int kind = dice.integer(0, 2);
    if (kind == 1) {
      instance.rules.lower[j] = -200 * kDegree;
      instance.rules.upper[j] = 400 * kDegree;
    } else if (kind == 2) {
      instance.rules.period[j] = kInfinity;
    }
  }
  return instance;
}

void make_continuous(LadderInstance& instance, Eigen::Index joint) {
  instance.rules.period[joint] = kTurn;
  instance.rules.lower[joint] = -kInfinity;
  instance.rules.upper[joint] = kInfinity;
}

void limit_steps(LadderInstance& instance, LadderDice& dice) {
  for (JointVector& step : instance.rules.max_step) {
    for (double& value : step) value = dice.chance(0.5) ? dice.uniform(0.2, 4) : kInfinity;
  }
}

/// A window of one to two turns on some rungs, so that every configuration has a copy in it.
void limit_some_rungs(LadderInstance& instance, LadderDice& dice) {
  for (Rung& rung : instance.rungs) {
    if (!dice.chance(0.3)) continue;
    rung.lower = instance.rules.lower;
    rung.upper = instance.rules.upper;
    for (Eigen::Index j = 0; j < rung.lower.size(); ++j) {
      rung.lower[j] = dice.uniform(rung.lower[j], rung.upper[j] - kTurn);
      rung.upper[j] = dice.uniform(rung.lower[j] + kTurn, rung.upper[j]);
    }
  }
}

TEST(LeastCostPathWithTurns, EqualsTheBestAmongCopies) {
  for (unsigned seed = 0; seed < 150; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const LadderInstance instance = random_instance(seed);
    const LadderPath path = solve(instance);
    EXPECT_TRUE(path.found);
    expect_optimum(instance, path);
    EXPECT_EQ(path.statistics.vertices, LadderOracle(instance).solve().vertices);
    if (HasFailure()) return;
  }
}

TEST(LeastCostPathWithTurns, OfContinuousJoints) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    LadderInstance instance = random_instance(1000 + seed);
    make_continuous(instance, 0);
    LadderDice dice(seed);
    if (seed % 2 == 0) limit_steps(instance, dice);
    expect_optimum(instance, solve(instance));
    if (HasFailure()) return;
  }
}

TEST(LeastCostPathWithTurns, OfJointsWithOneLimit) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    LadderInstance instance = random_instance(2000 + seed);
    make_continuous(instance, 0);
    (seed % 2 == 0 ? instance.rules.lower : instance.rules.upper)[0] = 0.7;
    if (seed % 3 == 0) {
      instance.rules.edge_cost = [](std::size_t, const JointVector& from, const JointVector& to) {
        return 0.1 * std::abs(to[0] - from[0]);
      };
    }
    expect_optimum(instance, solve(instance));
    if (HasFailure()) return;
  }
}

TEST(LeastCostPathWithTurns, KeepsTheStepLimit) {
  int infeasible = 0;
  for (unsigned seed = 0; seed < 150; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    LadderInstance instance = random_instance(3000 + seed);
    LadderDice dice(seed);
    limit_steps(instance, dice);
    const LadderPath path = solve(instance);
    expect_optimum(instance, path);
    infeasible += !path.found;
    if (HasFailure()) return;
  }
  EXPECT_GT(infeasible, 5);
  EXPECT_LT(infeasible, 100);
}

TEST(LeastCostPathWithTurns, KeepsTheLimitsOfARung) {
  for (unsigned seed = 0; seed < 150; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    LadderInstance instance = random_instance(4000 + seed);
    LadderDice dice(seed);
    limit_some_rungs(instance, dice);
    if (seed % 2 == 0) limit_steps(instance, dice);
    expect_optimum(instance, solve(instance));
    if (HasFailure()) return;
  }
}

/// A start that is fixed to one copy, also of a continuous joint.
TEST(LeastCostPathWithTurns, StartsAtTheCopyThatIsAskedFor) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    LadderInstance instance = random_instance(5000 + seed);
    if (seed % 2 == 0) make_continuous(instance, 0);
    LadderDice dice(seed);
    const int joints = static_cast<int>(instance.rules.weight.size());
    instance.rungs[0] = dice.rung(1, joints);
    JointVector start = instance.rungs[0].vertex(0);
    for (Eigen::Index j = 0; j < joints; ++j) {
      if (!std::isfinite(instance.rules.period[j])) continue;
      if (std::isinf(instance.rules.lower[j])) start[j] += kTurn * dice.integer(-2, 2);
      if (start[j] < -kTurn / 4) start[j] += kTurn;
    }
    instance.rungs[0].lower = instance.rungs[0].upper = start;
    if (seed % 3 == 0) block_moves(instance.rules, seed, 0.2);
    const LadderPath path = solve(instance);
    EXPECT_LT((path.positions[0] - start).cwiseAbs().maxCoeff(), 1e-9);
    if (seed % 6 == 0) continue;  // a continuous joint goes the shorter way round only
    expect_optimum(instance, path);
    if (HasFailure()) return;
  }
}

/// A start and an end that are fixed, with a seam between them that winds up a continuous joint.
TEST(LeastCostPathWithTurns, EndsAtTheCopyThatIsAskedFor) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    LadderDice dice(seed);
    const int rungs = 25, joints = 1 + static_cast<int>(seed % 2);
    LadderInstance instance{dice.drifting_rungs(rungs, 3, joints, 0.2, 0.5),
                            dice.rules(rungs, joints)};
    make_continuous(instance, 0);
    if (seed % 5 == 0) instance.rules.lower[0] = -1;
    instance.rules.squared = seed % 3 == 0;
    for (Rung* const rung : {&instance.rungs.front(), &instance.rungs.back()}) {
      *rung = dice.rung(1, joints);
      rung->lower = rung->upper = rung->vertex(0);
      if (seed % 4 == 0) rung->lower[0] = rung->upper[0] += kTurn * dice.integer(0, 3);
      if (seed % 5 == 0 && rung->lower[0] < -1) rung->lower[0] = rung->upper[0] += kTurn;
    }
    if (seed % 7 == 0) limit_steps(instance, dice);
    expect_optimum(instance, solve(instance));
    if (HasFailure()) return;
  }
}

/// More than two turns one after the other do not fit between the limits.
TEST(LeastCostPathWithTurns, Unwinds) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    LadderDice dice(seed);
    const int joints = 1 + static_cast<int>(seed % 2), count = 1 + static_cast<int>(seed % 5);
    LadderInstance instance{dice.drifting_rungs(45, count, joints, 0.3, 0.5),
                            dice.rules(45, joints)};
    instance.rules.squared = seed % 4 == 3;
    if (seed % 3 == 0) block_moves(instance.rules, seed, 0.1);
    const LadderPath path = solve(instance);
    expect_optimum(instance, path);
    double longest = 0;
    for (std::size_t i = 1; i < path.positions.size(); ++i) {
      longest = std::max(longest, std::abs(path.positions[i][0] - path.positions[i - 1][0]));
    }
    if (path.found && count == 1) {
      EXPECT_GT(longest, kTurn / 2);
    }
    if (HasFailure()) return;
  }
}

TEST(LeastCostPathWithTurns, WithoutAWayToUnwindGivesTheLongestPart) {
  LadderDice dice(1);
  LadderInstance instance{dice.drifting_rungs(45, 3, 1, 0.3, 0.5), dice.rules(45, 1)};
  for (JointVector& step : instance.rules.max_step) step.setConstant(1);
  const LadderPath path = solve(instance);
  EXPECT_FALSE(path.found);
  expect_optimum(instance, path);
  EXPECT_GT(path.positions.size(), 20U);
}

TEST(LeastCostPathWithTurns, GoesTheLongerWayRoundWhereTheShorterIsBlocked) {
  int longer = 0, infeasible = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    LadderInstance instance = random_instance(6000 + seed);
    LadderDice dice(seed);
    block_moves(instance.rules, seed, 0.1 + 0.089 * static_cast<double>(seed % 11));
    if (seed % 2 == 0) instance.rules.weight *= 0.01;
    if (seed % 5 == 0) limit_steps(instance, dice);
    const LadderPath path = solve(instance);
    expect_optimum(instance, path);
    infeasible += !path.found;
    for (std::size_t i = 1; i < path.positions.size(); ++i) {
      const JointVector step = (path.positions[i] - path.positions[i - 1]).cwiseAbs();
      for (Eigen::Index j = 0; j < step.size(); ++j) {
        longer += std::isfinite(instance.rules.period[j]) && step[j] > kTurn / 2;
      }
    }
    if (HasFailure()) return;
  }
  EXPECT_GT(longer, 50);
  EXPECT_GT(infeasible, 10);
}

/// The other vertex costs more than half a turn and less than a whole one.
TEST(LeastCostPathWithTurns, GoesALittleMoreThanHalfATurn) {
  LadderDice dice(1);
  LadderInstance instance{{dice.rung(1, 1), dice.rung(2, 1)}, dice.rules(2, 1)};
  instance.rules.weight.setOnes();
  instance.rungs[0].positions << 0;
  instance.rungs[1].positions << -kTurn / 2 + 0.1, 1;
  instance.rungs[0].cost.setZero();
  instance.rungs[1].cost << 0, 0.7 * kTurn - 1;
  instance.rules.is_clear = [](int, std::size_t, const JointVector& from, const JointVector& to) {
    return to[0] > from[0];
  };
  const LadderPath path = solve(instance);
  EXPECT_NEAR(path.cost, kTurn / 2 + 0.1, 1e-9);
  expect_optimum(instance, path);
}

/// Half a turn costs the same either way round, and only one of the two ways may be clear.
TEST(LeastCostPathWithTurns, ChecksTheHalfTurnThatItTakes) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    LadderDice dice(seed);
    const int rungs = 8, joints = dice.integer(1, 2);
    LadderInstance instance{dice.unrelated_rungs(rungs, 1, 4, joints), dice.rules(rungs, joints)};
    for (Rung& rung : instance.rungs) {
      rung.cost.setZero();
      for (double& value : rung.positions.reshaped()) value = 2 * dice.integer(-2, 1);
    }
    instance.rules.period.setConstant(8);
    instance.rules.lower.setConstant(-16);
    instance.rules.upper.setConstant(16);
    instance.rules.weight.setOnes();
    block_moves(instance.rules, seed, 0.1 + 0.1 * static_cast<double>(seed % 4));
    expect_optimum(instance, solve(instance));
    if (HasFailure()) return;
  }
}

TEST(LeastCostPathWithTurns, TakesTheHalfTurnThatIsClearAfterATurn) {
  LadderDice dice(1);
  LadderInstance instance{{}, dice.rules(3, 1)};
  for (const double value : {-3.0, 3.0, -1.0}) {
    instance.rungs.push_back(dice.rung(1, 1));
    instance.rungs.back().positions(0, 0) = value;
  }
  instance.rules.period.setConstant(8);
  instance.rules.lower.setConstant(-16);
  instance.rules.upper.setConstant(16);
  instance.rules.is_clear = [](int, std::size_t, const JointVector& from, const JointVector& to) {
    return to[0] - from[0] != -4;
  };
  expect_optimum(instance, solve(instance));
}

TEST(LeastCostPathWithTurns, AddsCostsThatDependOnTheTurns) {
  for (unsigned seed = 0; seed < 150; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    LadderInstance instance = random_instance(7000 + seed);
    LadderDice dice(seed);
    if (seed % 3 != 0) {
      instance.rules.vertex_cost = [](std::size_t i, const JointVector& q) {
        return 0.02 * q.squaredNorm() + 0.1 * (1 + std::sin(static_cast<double>(i) + q[0] / 3));
      };
    }
    if (seed % 3 != 1) {
      instance.rules.edge_cost = [](std::size_t, const JointVector& from, const JointVector& to) {
        return 0.3 * (1 + std::sin(from.sum() / 2 + to[0]));
      };
    }
    if (seed % 2 == 0) block_moves(instance.rules, seed, 0.3);
    if (seed % 5 == 0) limit_steps(instance, dice);
    if (seed % 7 == 0) limit_some_rungs(instance, dice);
    expect_optimum(instance, solve(instance));
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace wristwise
