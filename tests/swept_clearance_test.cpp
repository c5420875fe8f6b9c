#include "wristwise/swept_clearance.hpp"

#include <gtest/gtest.h>

#include "collision_robots.hpp"
#include "wristwise/error.hpp"

namespace wristwise {
namespace {

using test::arm;
using test::at;
using test::random_posture;
using test::uniform;
using test::workshop;

constexpr double kEpsilon = 5e-5;

/// Least distance of all pairs at evenly spaced postures.
double dense_minimum(ClearanceChecker& checker, const Motion& motion, int samples) {
  double least = HUGE_VAL;
  for (int i = 0; i <= samples; ++i) {
    checker.set_posture(motion.posture(static_cast<double>(i) / samples));
    if (const auto nearest = checker.nearest(least)) least = nearest->distance;
  }
  return least;
}

/// The torch only, so that random motions are clear often enough.
std::shared_ptr<const ClearanceModel> torch_model() {
  Scene scene = workshop();
  scene.scope = CollisionScope::pairs;
  scene.pairs = {{"torch", "table"}, {"torch", "post"}, {"torch", "ball"}, {"fore", "table"}};
  return std::make_shared<const ClearanceModel>(arm(), scene);
}

TEST(CheckMotion, AgreesWithDenseSampling) {
  ClearanceChecker checker(torch_model());
  const Robot& robot = checker.model().robot();
  std::mt19937 random(51);
  int clear = 0, blocked = 0;
  for (int sample = 0; sample < 100; ++sample) {
    const JointVector from = random_posture(robot, random);
    const JointVector to =
        from + uniform(random, 0.05, 0.7) * (random_posture(robot, random) - from);
    const StraightMove move(from, to);
    const double required = uniform(random, 0, 0.1);
    const SweptClearance swept = check_motion(checker, move, required, kEpsilon);
    const double least = dense_minimum(checker, move, 5000);
    if (swept.clear) {
      ++clear;
      EXPECT_GE(least, required - kEpsilon);
      EXPECT_GE(swept.bound, required - kEpsilon);
      EXPECT_LE(swept.bound, least + 1e-6);
      EXPECT_EQ(swept.pair, -1);
    } else {
      ++blocked;
      EXPECT_LT(least, required);
      checker.set_posture(move.posture(swept.s));
      EXPECT_EQ(checker.distance(swept.pair).distance, swept.distance);
      EXPECT_LT(swept.distance, required - 1e-6);
      EXPECT_EQ(checker.nearest()->distance, swept.distance);
    }
  }
  EXPECT_GT(clear, 10);
  EXPECT_GT(blocked, 10);
}

TEST(CheckMotion, FindsAThinObstacleBetweenClearEnds) {
  std::mt19937 random(52);
  int planted = 0;
  while (planted < 30) {
    const auto robot = arm();
    const JointVector from = random_posture(*robot, random);
    const JointVector to = from + 0.3 * (random_posture(*robot, random) - from);
    const StraightMove move(from, to);
    const double s = uniform(random, 0.1, 0.9);
    // A needle through the torch at s, clear of it at both ends.
    ChainPose chain;
    forward_kinematics(*robot, move.posture(s), chain);
    Scene scene;
    scene.scope = CollisionScope::pairs;
    scene.pairs = {{"torch", "needle"}};
    const Pose needle = chain.frame(6) * at(0.1, 0, 0);
    scene.objects = {{"needle", {{Cylinder{1e-4, 0.3}, needle}}}};
    const auto model = std::make_shared<const ClearanceModel>(robot, scene);
    ClearanceChecker checker(model);
    checker.set_posture(from);
    if (checker.first_below(0.01)) continue;
    checker.set_posture(to);
    if (checker.first_below(0.01)) continue;
    ++planted;
    const SweptClearance swept = check_motion(checker, move, 0);
    EXPECT_FALSE(swept.clear);
    EXPECT_EQ(swept.pair >= 0, true);
    EXPECT_LT(swept.distance, -1e-6);
    EXPECT_GT(swept.s, 0);
    EXPECT_LT(swept.s, 1);
  }
}

TEST(CheckMotion, SettlesAMoveThatHugsTheRequiredClearance) {
  // The rail carries the torch along a wall at a constant distance.
  const auto robot = arm();
  Scene scene;
  scene.scope = CollisionScope::pairs;
  scene.pairs = {{"carriage", "wall"}};
  // The carriage ends at x = 0.15.
  scene.objects = {{"wall", {{Box{{0.1, 5, 1}}, at(0.15 + 0.05 + 0.01, 0, 0.2)}}}};
  ClearanceChecker checker(std::make_shared<const ClearanceModel>(robot, scene));
  JointVector from = JointVector::Zero(7), to = from;
  from[0] = -0.5;
  to[0] = 0.7;
  const SweptClearance swept = check_motion(checker, StraightMove(from, to), 0.01, kEpsilon);
  EXPECT_TRUE(swept.clear);
  EXPECT_GE(swept.bound, 0.01 - kEpsilon);
  EXPECT_LE(swept.bound, 0.01);
  EXPECT_LT(swept.postures, 100000U);
  EXPECT_FALSE(check_motion(checker, StraightMove(from, to), 0.01 + 2e-6, kEpsilon).clear);
}

TEST(CheckMotion, ReportsTheEndsFirst) {
  ClearanceChecker checker(torch_model());
  const Robot& robot = checker.model().robot();
  std::mt19937 random(53);
  int start = 0, finish = 0;
  while (start < 5 || finish < 5) {
    const StraightMove move(random_posture(robot, random), random_posture(robot, random));
    checker.set_posture(move.posture(0));
    const bool starts_clear = !checker.first_below(0);
    checker.set_posture(move.posture(1));
    const bool ends_clear = !checker.first_below(0);
    if (starts_clear && ends_clear) continue;
    const SweptClearance swept = check_motion(checker, move, 0);
    EXPECT_FALSE(swept.clear);
    EXPECT_EQ(swept.s, starts_clear ? 1.0 : 0.0);
    ++(starts_clear ? finish : start);
  }
}

TEST(CheckMotion, WithoutPairsIsClearWithoutBound) {
  Scene scene = workshop();
  scene.scope = CollisionScope::off;
  ClearanceChecker checker(std::make_shared<const ClearanceModel>(arm(), scene));
  const StraightMove move(JointVector::Zero(7), JointVector::Ones(7));
  const SweptClearance swept = check_motion(checker, move, 0.1);
  EXPECT_TRUE(swept.clear);
  EXPECT_EQ(swept.bound, HUGE_VAL);
}

/// Its spread is no number.
class Boundless : public StraightMove {
 public:
  using StraightMove::StraightMove;
  JointVector spread(double, double) const override {
    return JointVector::Constant(7, std::nan(""));
  }
};

TEST(CheckMotion, RefusesWhatItCannotSettle) {
  ClearanceChecker checker(torch_model());
  JointVector q(7);
  q << 0, 0, -1, 0, 0, 0, 0;
  checker.set_posture(q);
  ASSERT_FALSE(checker.first_below(0));
  const Boundless boundless(q, q);
  EXPECT_THROW(check_motion(checker, boundless, 0), InvalidInput);
  const StraightMove still(q, q);
  EXPECT_TRUE(check_motion(checker, still, 0).clear);
  EXPECT_THROW(check_motion(checker, still, std::nan("")), InvalidInput);
  EXPECT_THROW(check_motion(checker, still, 0, 0), InvalidInput);
  EXPECT_THROW(check_motion(checker, still, 0, std::nan("")), InvalidInput);
}

TEST(StraightMove, SpreadBoundsTheDepartureFromTheMiddle) {
  std::mt19937 random(54);
  const auto robot = arm();
  for (int sample = 0; sample < 100; ++sample) {
    const StraightMove move(random_posture(*robot, random), random_posture(*robot, random));
    const double s0 = uniform(random, 0, 1), s1 = uniform(random, s0, 1);
    const JointVector spread = move.spread(s0, s1);
    const JointVector middle = move.posture((s0 + s1) / 2);
    for (int i = 0; i <= 10; ++i) {
      const JointVector away = move.posture(s0 + (s1 - s0) * i / 10) - middle;
      EXPECT_TRUE((away.cwiseAbs().array() <= spread.array() + 1e-12).all());
    }
  }
}

}  // namespace
}  // namespace wristwise
