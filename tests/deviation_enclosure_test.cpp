// What is claimed of the deviation for all t (F30) against dense samples of it.

#include "task/deviation_enclosure.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "random_arm.hpp"
#include "task/corner_blend.hpp"
#include "task/run_curve.hpp"
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

/// Which pieces a seam is made of.
enum class Pieces {
  straight_and_round,  ///< lines and arcs
  curves,              ///< rounded corners, run-ins and run-outs
};

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

SeamPiece line_or_arc(Dice& dice, const Pose& from, double speed) {
  SeamPiece piece;
  piece.kind = dice.sign() > 0 ? SeamPiece::Kind::line : SeamPiece::Kind::arc;
  piece.from = from;
  if (piece.kind == SeamPiece::Kind::arc) {
    piece.center = from.translation() + dice.vector(0.2);
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
  return piece;
}

/// A place where a piece of about the given size (m, rad) is left or joined.
PathPoint any_point(Dice& dice, const Pose& frame, double size) {
  PathPoint point;
  point.frame = frame;
  point.tangent = dice.rotation().col(0);
  if (dice.sign() > 0) point.curvature = 0.5 / size * point.tangent.cross(dice.rotation().col(0));
  if (dice.sign() > 0) point.turning = dice.vector(1);
  return point;
}

SeamPiece blend_or_run(Dice& dice, const Pose& from, double speed) {
  const PathPoint start = any_point(dice, from, speed);
  SeamPiece piece;
  piece.kind = SeamPiece::Kind::curve;
  if (dice.sign() > 0) {
    const double distance = speed * dice.uniform(0.3, 1);
    PathPoint end = any_point(dice, from, speed);
    end.frame.translation() += distance * (start.tangent + end.tangent);
    end.frame.linear() *=
        Eigen::AngleAxisd(speed * dice.uniform(-3, 3), dice.rotation().col(0)).toRotationMatrix();
    piece.curve = std::make_shared<const CornerBlend>(start, end, distance);
  } else {
    const auto way = dice.sign() > 0 ? RunCurve::Way::in : RunCurve::Way::out;
    piece.curve = std::make_shared<const RunCurve>(
        way, start, speed, from.translation() + speed * dice.vector(1), 1.4);
  }
  piece.from = piece.curve->frame_at(0);
  piece.to = piece.curve->frame_at(1);
  return piece;
}

/// A law that has no knot inside the interval and stays on the piece there. It may stand still at
/// its knots, and crawl between them.
Trajectory any_law(Dice& dice) {
  const auto number = [](double value) { return JointVector::Constant(1, value); };
  const bool starts_at_knot = dice.sign() > 0, ends_at_knot = dice.sign() > 0;
  const std::vector<double> times{2.5, starts_at_knot ? kStart : dice.uniform(2.6, kStart),
                                  ends_at_knot ? kEnd : dice.uniform(kEnd, 4.3), 4.5};
  const double passed = dice.uniform(2.75, 3.3);
  const std::vector<double> nominal{2.65, passed, passed + 0.7 * std::pow(10, dice.uniform(-3, 0)),
                                    4.15};
  std::vector<JointVector> positions, rates;
  for (std::size_t i = 0; i < times.size(); ++i) {
    double slowest = INFINITY;
    for (std::size_t k = std::max<std::size_t>(i, 1); k <= std::min<std::size_t>(i + 1, 3); ++k)
      slowest = std::min(slowest, (nominal[k] - nominal[k - 1]) / (times[k] - times[k - 1]));
    positions.push_back(number(nominal[i]));
    rates.push_back(number(dice.uniform(0, 1) < 0.4 ? 0 : dice.uniform(0, 1.5) * slowest));
  }
  return {times, positions, rates, std::vector<JointVector>(times.size(), number(0))};
}

/// The seam starts near where the TCP is; it runs on before and after the interval.
Case any_case(Dice& dice, double speed, Pieces pieces = Pieces::straight_and_round) {
  const Robot robot = any_arm(dice);
  MotionPiece::Polynomials joints(6, 6);
  joints.col(0) = dice.posture();
  for (int k = 1; k < 6; ++k) {
    for (int j = 0; j < 6; ++j) joints(j, k) = std::pow(speed, k) * dice.uniform(-1, 1);
  }
  Pose from = tcp_pose(robot, joints.col(0));
  from.linear() *=
      Eigen::AngleAxisd(dice.uniform(-1.2, 1.2), dice.rotation().col(0)).toRotationMatrix();
  from.translation() += dice.vector(0.01);
  SeamPiece piece =
      pieces == Pieces::curves ? blend_or_run(dice, from, speed) : line_or_arc(dice, from, speed);
  piece.start_time = 2.7;
  piece.end_time = 4.1;
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

/// Neither bounds nor boxes; true where a box a little larger than what was sampled is shown.
bool shows_and_is_not_optimistic(Dice& dice, const Case& given) {
  const DeviationEnclosure enclosed = enclose(given);
  const Truth truth = sampled(given);
  EXPECT_GE(enclosed.distance(), truth.distance - 1e-12);
  EXPECT_GE(enclosed.angle(), truth.angle - 1e-9);
  const ToleranceBox box = around(given, truth, std::pow(10, dice.uniform(-6, -1)));
  for (int k = 0; k < 6; ++k) {
    if (box.is_free(k)) continue;
    ToleranceBox small = around(given, truth, 10);
    const double cut = std::pow(10, dice.uniform(-9, -1));
    dice.sign() > 0 ? small.upper[k] = truth.largest[k] - cut
                    : small.lower[k] = truth.least[k] + cut;
    EXPECT_FALSE(enclosed.inside(small)) << "coordinate " << k;
  }
  return enclosed.inside(box);
}

int count_shown(unsigned seed, int trials, Pieces pieces, bool retimed) {
  Dice dice(seed);
  int shown = 0;
  for (int trial = 0; trial < trials; ++trial) {
    SCOPED_TRACE(trial);
    Case given = any_case(dice, std::pow(10, dice.uniform(-3, -0.3)), pieces);
    if (retimed) given.seam = given.seam.retimed(any_law(dice));
    if (shows_and_is_not_optimistic(dice, given)) ++shown;
  }
  return shown;
}

// That many are shown says that the enclosure is of use.

TEST(DeviationEnclosure, IsNeverOptimistic) {
  EXPECT_GT(count_shown(11, 4000, Pieces::straight_and_round, false), 2000);
}

TEST(DeviationEnclosure, IsNeverOptimisticUnderATimeLaw) {
  EXPECT_GT(count_shown(21, 2000, Pieces::straight_and_round, true), 800);
}

TEST(DeviationEnclosure, IsNeverOptimisticOnRoundedCornersAndRuns) {
  EXPECT_GT(count_shown(22, 2000, Pieces::curves, false), 350);
}

TEST(DeviationEnclosure, IsNeverOptimisticOnCurvesUnderATimeLaw) {
  EXPECT_GT(count_shown(23, 2000, Pieces::curves, true), 350);
}

/// A course of which only single frames are known.
class UnknownCurve final : public SeamCurve {
 public:
  double length() const override { return 1; }
  Pose frame_at(double /*fraction*/) const override { return Pose::Identity(); }
};

TEST(DeviationEnclosure, NothingIsShownOnACurveOfWhichNothingIsKnown) {
  Dice dice(24);
  Case given = any_case(dice, 0.001);
  SeamPiece piece = given.seam.pieces().front();
  piece.kind = SeamPiece::Kind::curve;
  piece.curve = std::make_shared<const UnknownCurve>();
  given.seam = Seam({piece});
  for (const ToleranceFrame frame : {ToleranceFrame::path, ToleranceFrame::base}) {
    for (int bounded = 0; bounded < 6; ++bounded) {
      given.box = ToleranceBox();
      given.box.frame = frame;
      given.box.upper.tail<3>().setConstant(ToleranceBox::kFree);
      given.box.upper.head<3>().setConstant(1e3);
      given.box.upper[bounded] = 1;
      given.box.lower = -given.box.upper;
      const DeviationEnclosure enclosed = enclose(given);
      EXPECT_FALSE(enclosed.inside(given.box));
      EXPECT_GT(enclosed.distance(), 1e6);
      if (bounded >= 3) {
        EXPECT_GE(enclosed.angle(), 0.5 * Dice::kPi) << bounded;
      }
    }
  }
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
