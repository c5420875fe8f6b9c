#include "graph/known_checks.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace wristwise {
namespace {

constexpr double kTurn = 6.28318530717958647692;

std::vector<Rung> two_rungs(int joints) {
  std::vector<Rung> rungs(2);
  for (Rung& rung : rungs) {
    rung.positions.resize(3, joints);
    rung.cost = Eigen::ArrayXd::Zero(3);
    for (Eigen::Index v = 0; v < 3; ++v) rung.positions.row(v).setConstant(0.5 * double(v));
  }
  return rungs;
}

EdgeRules circular_rules(int joints) {
  EdgeRules rules;
  rules.weight = JointVector::Ones(joints);
  rules.period = JointVector::Constant(joints, kTurn);
  rules.lower = JointVector::Constant(joints, -100);
  rules.upper = JointVector::Constant(joints, 100);
  return rules;
}

TEST(KnownChecks, AskOnceAboutAConfiguration) {
  const std::vector<Rung> rungs = two_rungs(2);
  EdgeRules rules = circular_rules(2);
  int asked = 0;
  rules.is_usable = [&asked](int, std::size_t rung, const JointVector& q) {
    ++asked;
    return !(rung == 1 && q[0] == 0.5);
  };
  KnownChecks known(rungs, rules);
  EXPECT_TRUE(known.is_unknown(1, 1));
  EXPECT_FALSE(known.is_blocked(1, 1));
  for (int k = 0; k < 2; ++k) {
    EXPECT_FALSE(known.is_usable(0, 1, 1));
    EXPECT_TRUE(known.is_usable(0, 1, 2));
    EXPECT_TRUE(known.is_usable(0, 0, 1));
  }
  EXPECT_EQ(asked, 3);
  EXPECT_EQ(known.usable_checks(), 3U);
  EXPECT_EQ(known.blocked(), 1U);
  EXPECT_TRUE(known.is_blocked(1, 1));
  EXPECT_FALSE(known.is_blocked(1, 2));
  EXPECT_FALSE(known.is_blocked(0, 1));
  EXPECT_FALSE(known.is_unknown(1, 1));
  EXPECT_TRUE(known.is_unknown(1, 0));
}

TEST(KnownChecks, KnowEveryConfigurationWhereThereIsNothingToAsk) {
  const std::vector<Rung> rungs = two_rungs(1);
  const EdgeRules rules = circular_rules(1);
  KnownChecks known(rungs, rules);
  EXPECT_TRUE(known.is_usable(0, 0, 0));
  EXPECT_FALSE(known.is_unknown(0, 0));
  EXPECT_EQ(known.usable_checks(), 0U);
}

TEST(KnownChecks, ShareAMoveAmongCopiesShiftedByTheSameTurns) {
  const std::vector<Rung> rungs = two_rungs(2);
  const EdgeRules rules = circular_rules(2);
  const KnownChecks known(rungs, rules);
  const JointVector from = rungs[0].vertex(1), to = rungs[1].vertex(2);
  JointVector shift(2);
  shift << 2 * kTurn, -kTurn;
  const auto move = known.move(0, 1, 2, from, to);
  EXPECT_EQ(move, known.move(0, 1, 2, from + shift, to + shift));
  EXPECT_FALSE(move == known.move(0, 1, 2, from, to + shift));
  EXPECT_FALSE(move == known.move(0, 1, 2, from + shift, to));
  EXPECT_FALSE(move == known.move(0, 2, 1, to, from));
}

/// For each two joints of the most there may be.
TEST(KnownChecks, TellMovesApartByTheTurnsOfEachJoint) {
  for (const int joints : {1, 3, kMaxJoints}) {
    const std::vector<Rung> rungs = two_rungs(joints);
    const EdgeRules rules = circular_rules(joints);
    const KnownChecks known(rungs, rules);
    const JointVector from = rungs[0].vertex(0), to = rungs[1].vertex(1);
    std::vector<KnownChecks::Move> moves = {known.move(0, 0, 1, from, to)};
    for (int j = 0; j < joints; ++j) {
      for (const int turn : {-2, -1, 1, 2}) {
        JointVector turned = to;
        turned[j] += turn * kTurn;
        moves.push_back(known.move(0, 0, 1, from, turned));
      }
    }
    for (std::size_t a = 0; a < moves.size(); ++a) {
      for (std::size_t b = 0; b < a; ++b) EXPECT_FALSE(moves[a] == moves[b]) << a << ", " << b;
    }
  }
}

TEST(KnownChecks, CountMoves) {
  const std::vector<Rung> rungs = two_rungs(1);
  const EdgeRules rules = circular_rules(1);
  KnownChecks known(rungs, rules);
  const auto move = [&](Eigen::Index from, Eigen::Index to, int turns) {
    const JointVector turned = rungs[1].vertex(to).array() + turns * kTurn;
    return known.move(0, from, to, rungs[0].vertex(from), turned);
  };
  known.add(0, {{move(0, 1, 0), true}, {move(0, 1, 1), true}});
  EXPECT_FALSE(known.any_move_blocked());
  known.add(0, {{move(0, 1, 1), true}, {move(2, 1, 0), false}});
  EXPECT_EQ(known.clear_checks(), 3U);
  EXPECT_TRUE(known.any_move_blocked());
  EXPECT_EQ(known.moves(0).size(), 3U);
  EXPECT_TRUE(known.moves(1).empty());
}

}  // namespace
}  // namespace wristwise
