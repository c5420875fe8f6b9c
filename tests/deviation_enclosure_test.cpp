// What is claimed of the deviation for all t (F30) against dense samples of it.

#include "task/deviation_enclosure.hpp"

#include <gtest/gtest.h>

#include "random_arm.hpp"
#include "wristwise/kinematics.hpp"

namespace wristwise {
namespace {

using test::Dice;

constexpr int kSamples = 300;
constexpr double kStart = 3, kEnd = 3.5;  // s

/// A random arm, some of whose joints may slide instead of turn.
Robot any_arm(Dice& dice) {
  const Robot arm = test::random_arm(dice, {});
  Robot::Parts parts;
  parts.name = arm.name();
  parts.joints = arm.joints();
  parts.tcp = arm.tcp();
  for (Joint& joint : parts.joints) {
    if (dice.uniform(0, 1) > 0.2) continue;
    joint.type = JointType::prismatic;
    joint.lower = -5;
    joint.upper = 5;
  }
  return Robot(parts);
}

struct Case {
  Robot robot;
  MotionPiece motion;
  Seam seam;
  ToleranceBox box;
};

ToleranceBox any_box(Dice& dice) {
  ToleranceBox box;
  box.frame = dice.sign() > 0 ? ToleranceFrame::path : ToleranceFrame::base;
  for (int k = 3; k < 6; ++k) {
    if (dice.uniform(0, 1) < 0.7) continue;
    box.lower[k] = -ToleranceBox::kFree;
    box.upper[k] = ToleranceBox::kFree;
  }
  return box;
}

/// The seam starts near where the TCP is; it runs on before and after the interval.
Case any_case(Dice& dice, double speed) {
  const Robot robot = any_arm(dice);
  MotionPiece::Polynomials joints(6, 6);
  joints.col(0) = dice.posture();
  for (int k = 1; k < 6; ++k) {
    for (int j = 0; j < 6; ++j) joints(j, k) = std::pow(speed, k) * dice.uniform(-1, 1);
  }
  const Pose tcp = tcp_pose(robot, joints.col(0));
  SeamPiece piece;
  piece.kind = dice.sign() > 0 ? SeamPiece::Kind::line : SeamPiece::Kind::arc;
  piece.start_time = 2.7;
  piece.end_time = 4.1;
  const Eigen::Matrix3d tilt =
      Eigen::AngleAxisd(dice.uniform(-1.2, 1.2), dice.rotation().col(0)).toRotationMatrix();
  piece.from.linear() = tcp.linear() * tilt;
  piece.from.translation() = tcp.translation() + dice.vector(0.01);
  if (piece.kind == SeamPiece::Kind::arc) {
    piece.center = tcp.translation() + dice.vector(0.2);
    piece.axis = dice.rotation().col(0);
    piece.angle = speed * dice.uniform(-3, 3);
    piece.to = Eigen::Translation3d(piece.center) * Eigen::AngleAxisd(piece.angle, piece.axis) *
               Eigen::Translation3d(-piece.center) * piece.from;
  } else {
    piece.to.linear() =
        piece.from.linear() *
        Eigen::AngleAxisd(speed * dice.uniform(-3, 3), dice.rotation().col(0)).toRotationMatrix();
    piece.to.translation() = piece.from.translation() + speed * dice.vector(1);
  }
  return {robot, MotionPiece(kStart, kEnd, joints), Seam({piece}), any_box(dice)};
}

struct Truth {
  Vector6 least = Vector6::Constant(INFINITY), largest = Vector6::Constant(-INFINITY);
  double distance = 0, angle = 0;
};

Truth sampled(const Case& given) {
  Truth truth;
  for (int i = 0; i <= kSamples; ++i) {
    const double t = kStart + (kEnd - kStart) * i / kSamples;
    const Vector6 e = deviation(given.box, given.seam.frame_at(t),
                                tcp_pose(given.robot, given.motion.posture(t)));
    truth.least = truth.least.cwiseMin(e);
    truth.largest = truth.largest.cwiseMax(e);
    truth.distance = std::max(truth.distance, e.head<3>().norm());
    for (int k = 3; k < 6; ++k) {
      if (!given.box.is_free(k)) truth.angle = std::max(truth.angle, std::abs(e[k]));
    }
  }
  return truth;
}

DeviationEnclosure enclose(const Case& given) {
  return {given.robot, given.motion.over(kStart, kEnd), given.seam, kStart, kEnd, given.box};
}

/// A box around what was sampled, `slack` wider.
ToleranceBox around(const Case& given, const Truth& truth, double slack) {
  ToleranceBox box = given.box;
  for (int k = 0; k < 6; ++k) {
    if (box.is_free(k)) continue;
    box.lower[k] = truth.least[k] - slack;
    box.upper[k] = truth.largest[k] + slack;
  }
  return box;
}

TEST(DeviationEnclosure, IsNeverOptimistic) {
  Dice dice(11);
  int shown = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    const Case given = any_case(dice, std::pow(10, dice.uniform(-3, -0.3)));
    const DeviationEnclosure enclosed = enclose(given);
    const Truth truth = sampled(given);
    EXPECT_GE(enclosed.distance(), truth.distance - 1e-12) << trial;
    EXPECT_GE(enclosed.angle(), truth.angle - 1e-9) << trial;
    ToleranceBox box = around(given, truth, std::pow(10, dice.uniform(-6, -1)));
    if (enclosed.inside(box)) ++shown;
    for (int k = 0; k < 6; ++k) {
      if (box.is_free(k)) continue;
      ToleranceBox small = around(given, truth, 10);
      const double cut = std::pow(10, dice.uniform(-9, -1));
      dice.sign() > 0 ? small.upper[k] = truth.largest[k] - cut
                      : small.lower[k] = truth.least[k] + cut;
      EXPECT_FALSE(enclosed.inside(small)) << trial << " coordinate " << k;
    }
  }
  EXPECT_GT(shown, 2000);  // nor is it of no use
}

/// Slow motions are enclosed tightly: the fourth order leaves next to nothing.
TEST(DeviationEnclosure, IsTightOverAShortInterval) {
  Dice dice(12);
  int tight = 0, all = 0;
  for (int trial = 0; trial < 500; ++trial) {
    const Case given = any_case(dice, 0.005);
    const Truth truth = sampled(given);
    // The angles of a base frame near 90 deg, and those that wrap, are another matter.
    if (truth.angle > 1.3 || (truth.largest - truth.least).maxCoeff() > 1) continue;
    ++all;
    if (enclose(given).inside(around(given, truth, 1e-6))) ++tight;
  }
  EXPECT_GT(all, 200);
  EXPECT_GT(tight, 0.95 * all) << all;
}

}  // namespace
}  // namespace wristwise
