#include "graph/move_checker.hpp"

#include <gtest/gtest.h>

#include <random>

#include "gantry.hpp"
#include "wristwise/swept_clearance.hpp"

namespace wristwise {
namespace {

namespace gantry = test::gantry;
using gantry::posture;

Task straight_task() { return gantry::task({{0, 0, 0}, {1, 0, 0}}, 4, 4, gantry::box(0.01, 1)); }

MoveChecker::Limits stray_limit(double stray) {
  return {stray, gantry::kUnlimited, gantry::kUnlimited};
}

TEST(MoveChecker, StrayIsTheExcessOverTheToleranceAlongTheMove) {
  const MoveChecker checker(straight_task(), gantry::clearance(gantry::robot()), stray_limit(1),
                            5e-5, 1);
  EXPECT_NEAR(checker.stray(1, posture(0.25, 0, 0), posture(0.5, 0, 0)), 0, 1e-12);
  EXPECT_NEAR(checker.stray(1, posture(0.25, 0, 0, 1), posture(0.5, 0, 0, -1)), 0, 1e-12);
  // Three quarters of the way to y = 0.4.
  EXPECT_NEAR(checker.stray(1, posture(0.25, 0, 0), posture(0.5, 0.4, 0)), 0.29, 1e-12);
  // At rest where the seam moves on by 0.1875 m.
  EXPECT_NEAR(checker.stray(1, posture(0.25, 0, 0), posture(0.25, 0, 0)), 0.1775, 1e-12);
  EXPECT_NEAR(checker.stray(1, posture(0.25, 0.02, 0.03), posture(0.5, 0.02, 0.03)),
              std::hypot(0.01, 0.02), 1e-12);
}

TEST(MoveChecker, StrayIsZeroWhereNoPathIsPrescribed) {
  Task task = straight_task();
  std::vector<SeamPiece> pieces = task.seam.pieces();
  pieces[0].kind = SeamPiece::Kind::move;
  task.seam = Seam(pieces);
  MoveChecker checker(task, gantry::clearance(gantry::robot()), stray_limit(0), 5e-5, 1);
  EXPECT_EQ(checker.stray(1, posture(0, 1, 0), posture(1, -1, 0)), 0);
  EXPECT_TRUE(checker.is_clear(0, 1, posture(0, 1, 0), posture(1, -1, 0)));
}

TEST(MoveChecker, BlocksMovesThatStrayTooFar) {
  const auto clearance = gantry::clearance(gantry::robot());
  MoveChecker checker(straight_task(), clearance, stray_limit(0.3), 5e-5, 1);
  EXPECT_TRUE(checker.is_clear(0, 1, posture(0.25, 0, 0), posture(0.5, 0.4, 0)));
  EXPECT_FALSE(checker.is_clear(0, 1, posture(0.25, 0, 0), posture(0.5, 0.42, 0)));
  EXPECT_EQ(checker.queries(), 0U);
}

TEST(MoveChecker, BlocksStepsOfTheTcpThatAreTooLong) {
  const auto clearance = gantry::clearance(gantry::robot());
  const double any = gantry::kUnlimited;
  const MoveChecker by_step(straight_task(), clearance, {any, 0.3, any}, 5e-5, 1);
  EXPECT_FALSE(by_step.steps_too_far(posture(0, 0, 0, 0), posture(0.18, 0.24, 0, 3)));
  EXPECT_TRUE(by_step.steps_too_far(posture(0, 0, 0, 0), posture(0.18, 0.2401, 0, 0)));
  const MoveChecker by_turn(straight_task(), clearance, {any, any, 0.5}, 5e-5, 1);
  EXPECT_FALSE(by_turn.steps_too_far(posture(0, 0, 0, -0.3), posture(1, 0, 0, 0.2)));
  EXPECT_TRUE(by_turn.steps_too_far(posture(0, 0, 0, -0.3), posture(1, 0, 0, 0.201)));
}

/// The short cut through the pair that was too near last must not change an answer.
TEST(MoveChecker, MeasuresPosturesAsTheCheckerDoes) {
  const auto clearance =
      gantry::clearance(gantry::robot(),
                        {gantry::obstacle(Sphere{0.2}, 0.2, 0.3, 0),
                         {"plate", {{Box{{0.02, 1, 1}}, Pose(Eigen::Translation3d(-0.4, 0, 0))}}}},
                        0.03);
  MoveChecker moves(straight_task(), clearance, stray_limit(1), 5e-5, 2);
  ClearanceChecker own(clearance);
  std::mt19937 random(2);
  std::uniform_real_distribution<double> value(-0.7, 0.7);
  int clear = 0;
  for (int i = 0; i < 500; ++i) {
    const JointVector q = posture(value(random), value(random), value(random));
    own.set_posture(q);
    const bool expected = !own.first_below(0.03);
    EXPECT_EQ(moves.has_clearance(i % 2, 1, q), expected);
    if (expected) ++clear;
  }
  EXPECT_GT(clear, 100);
  EXPECT_LT(clear, 450);
}

/// The short cut through the place that blocked the last move must not change an answer.
TEST(MoveChecker, AnswersAsCheckMotionWhateverWasAskedBefore) {
  const auto clearance =
      gantry::clearance(gantry::robot(),
                        {gantry::obstacle(Sphere{0.2}, 0.2, 0.3, 0),
                         {"plate", {{Box{{0.02, 1, 1}}, Pose(Eigen::Translation3d(-0.4, 0, 0))}}}},
                        0.03);
  MoveChecker checker(straight_task(), clearance, stray_limit(gantry::kUnlimited), 5e-5, 2);
  ClearanceChecker own(clearance);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> value(-0.7, 0.7);
  const auto any = [&] { return posture(value(random), value(random), value(random)); };
  int clear = 0;
  for (int i = 0; i < 300; ++i) {
    const JointVector from = any(), to = any();
    const bool expected = check_motion(own, StraightMove(from, to), 0.03, 5e-5).clear;
    EXPECT_EQ(checker.is_clear(i % 2, 1, from, to), expected);
    if (expected) ++clear;
  }
  EXPECT_GT(clear, 30);
  EXPECT_LT(clear, 270);
  EXPECT_GT(checker.queries(), 0U);
}

}  // namespace
}  // namespace wristwise
