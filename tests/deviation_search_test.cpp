// The search for where a motion leaves its box (F30), on a gantry whose deviation can be written
// down.

#include "task/deviation_search.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "gantry.hpp"

namespace wristwise {
namespace {

namespace gantry = test::gantry;

/// From (0, 0, 0) to (1, 0, 0) and on to (1, 1, 0), 1 s each.
Seam corner() {
  return gantry::task({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, 2, 1, gantry::box(1, 1)).seam;
}

DeviationFinding search(const MotionPiece& motion, const Seam& seam, const ToleranceBox& box,
                        DeviationGoal goal = {}) {
  return search_deviation(*gantry::robot(), motion, motion.start(), motion.end(), seam, box, goal);
}

MotionPiece straight(double t0, double t1, const JointVector& from, const JointVector& to) {
  return {t0, t1, from, to};
}

TEST(DeviationSearch, ShowsAMotionAlongTheSeam) {
  const auto found = search(straight(0, 1, gantry::posture(0, 0, 0), gantry::posture(1, 0, 0)),
                            corner(), gantry::box(0, 0));
  EXPECT_TRUE(found.not_shown.empty());
  EXPECT_TRUE(found.excess.isZero(0));
  EXPECT_LT(found.distance, 1e-6);
  EXPECT_EQ(found.samples, 1U);
}

/// The chord of the corner: x lags by up to 1/2 in the first half, where the seam turns.
TEST(DeviationSearch, CutsAtTheCornerOfTheSeam) {
  const auto chord = straight(0, 2, gantry::posture(0, 0, 0), gantry::posture(1, 1, 0));
  const auto found = search(chord, corner(), gantry::box(0.2, 0.1));
  EXPECT_NEAR(found.excess[0], 0.3, 0.02 * 0.3);
  EXPECT_NEAR(found.excess[1], 0.3, 0.02 * 0.3);
  EXPECT_NEAR(found.time[0], 1, 0.03);
  EXPECT_GE(found.distance, std::sqrt(0.5) - 1e-12);
  ASSERT_FALSE(found.not_shown.empty());
  // Outside where |t / 2 - t| > 0.2.
  EXPECT_LE(found.not_shown.front().first, 0.4);
  EXPECT_GE(found.not_shown.back().second, 1.6);
  EXPECT_TRUE(search(chord, corner(), gantry::box(0.5, 0.1)).not_shown.empty());
}

TEST(DeviationSearch, PassesOverMoves) {
  SeamPiece piece;
  piece.kind = SeamPiece::Kind::move;
  piece.to.translation() << 1, 0, 0;
  piece.end_time = 1;
  const auto found = search(straight(0, 1, gantry::posture(0, 1, 0), gantry::posture(1, 1, 0)),
                            Seam({piece}), gantry::box(0, 0));
  EXPECT_TRUE(found.not_shown.empty());
  EXPECT_EQ(found.samples, 0U);
  EXPECT_EQ(found.distance, 0);
}

/// With no width and no epsilon even 1e-15 m is outside: the search ends all the same.
TEST(DeviationSearch, EndsWithoutAnyEpsilon) {
  DeviationGoal goal;
  goal.position_epsilon = goal.angle_epsilon = 0;
  MotionPiece::Polynomials joints = MotionPiece::Polynomials::Zero(4, 6);
  joints.col(0) = gantry::posture(0.5, 0, 0);
  joints.col(1) = gantry::posture(0.5, 0, 0);
  joints(1, 5) = 1e-15;
  const auto found = search(MotionPiece(0, 1, joints), corner(), gantry::box(0, 0), goal);
  EXPECT_FALSE(found.not_shown.empty());
  EXPECT_LT(found.excess.maxCoeff(), 1.1e-15);
  EXPECT_LT(found.samples, 4300U);
}

/// Beyond the seam's end the frame stands still.
TEST(DeviationSearch, HoldsTheFrameBeyondTheEnds) {
  const auto wait = straight(2, 2.5, gantry::posture(1, 1, 0), gantry::posture(1, 1, 0));
  EXPECT_TRUE(search(wait, corner(), gantry::box(0, 0)).not_shown.empty());
}

}  // namespace
}  // namespace wristwise
