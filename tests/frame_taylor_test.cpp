// The path frame over an interval of time (F29) against the frame itself: every kind of piece, with
// and without a time law.

#include "task/frame_taylor.hpp"

#include <gtest/gtest.h>

#include "random_arm.hpp"
#include "task/corner_blend.hpp"
#include "task/run_curve.hpp"

namespace wristwise {
namespace {

using test::Dice;

constexpr double kEnd = 4;  // s, of the seam

Pose any_pose(Dice& dice) {
  Pose pose = Pose::Identity();
  pose.linear() = dice.rotation();
  pose.translation() = dice.vector(0.3);
  return pose;
}

/// A run-in, a line, a rounded corner and an arc, 1 s each.
Seam any_seam(Dice& dice) {
  std::vector<SeamPiece> pieces(4);
  SeamPiece& line = pieces[1];
  line.from = any_pose(dice);
  line.to = any_pose(dice);
  line.to.linear() =
      line.from.linear() *
      Eigen::AngleAxisd(dice.uniform(-1, 1), dice.rotation().col(0)).toRotationMatrix();
  SeamPiece& arc = pieces[3];
  arc.kind = SeamPiece::Kind::arc;
  arc.from = line.to;
  arc.from.translation() += dice.vector(0.05);
  arc.center = arc.from.translation() + dice.vector(0.2);
  arc.axis = dice.rotation().col(0);
  arc.angle = dice.uniform(-2, 2);
  arc.to = Eigen::Translation3d(arc.center) * Eigen::AngleAxisd(arc.angle, arc.axis) *
           Eigen::Translation3d(-arc.center) * arc.from;
  const PathPoint leaves = path_point(line, 1), joins = path_point(arc, 0);
  SeamPiece& blend = pieces[2];
  blend.kind = SeamPiece::Kind::curve;
  blend.curve = std::make_shared<CornerBlend>(leaves, joins, 0.02);
  SeamPiece& run_in = pieces[0];
  run_in.kind = SeamPiece::Kind::curve;
  const PathPoint begins = path_point(line, 0);
  run_in.curve = std::make_shared<RunCurve>(
      RunCurve::Way::in, begins, 0.1, begins.frame.translation() - 0.05 * begins.tangent, 1.0);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    pieces[i].start_time = static_cast<double>(i);
    pieces[i].end_time = static_cast<double>(i) + 1;
    if (pieces[i].kind != SeamPiece::Kind::curve) continue;
    pieces[i].from = pieces[i].curve->frame_at(0);
    pieces[i].to = pieces[i].curve->frame_at(1);
  }
  return Seam(pieces);
}

/// Down to rest at nominal 2 s, where it waits for 0.5 s, and up again.
Seam with_a_stop(const Seam& seam) {
  const auto values = [](const std::vector<double>& all) {
    std::vector<JointVector> vectors;
    for (const double value : all) vectors.push_back(JointVector::Constant(1, value));
    return vectors;
  };
  return seam.retimed(Trajectory({0, 1.5, 2.5, 3, 4, 5.5}, values({0, 1.5, 2, 2, 2.5, 4}),
                                 values({1, 1, 0, 0, 1, 1}), values({0, 0, 0, 0, 0, 0})));
}

double off(const VectorTaylor& f, double s, const Eigen::Vector3d& truth) {
  return (f.c[0] + s * (f.c[1] + s * (f.c[2] + s * f.c[3])) - truth).norm();
}

TEST(FrameTaylor, EnclosesEveryKindOfPieceUnderATimeLaw) {
  Dice dice(21);
  int tight = 0, all = 0;
  for (int trial = 0; trial < 100; ++trial) {
    const Seam steady = any_seam(dice);
    for (const Seam& seam : {steady, with_a_stop(steady)}) {
      std::vector<double> cuts = {-0.1};
      for (const double t : seam_breaks(seam, -0.1, 5.7)) cuts.push_back(t);
      cuts.push_back(5.7);
      EXPECT_EQ(cuts.size(), seam.is_retimed() ? 10U : 7U);
      for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        double t0 = cuts[i], t1 = cuts[i + 1];
        const double length = (t1 - t0) * std::pow(10, dice.uniform(-2, 0));
        t0 = dice.uniform(t0, t1 - length);
        t1 = t0 + length;
        const FrameTaylor frame(seam, t0, t1);
        const bool is_curve = seam.piece_at(0.5 * (t0 + t1)).kind == SeamPiece::Kind::curve;
        const Eigen::Vector3d fixed = dice.vector(1);
        const VectorTaylor seen = frame.point(VectorTaylor::constant(fixed));
        const VectorTaylor towards = frame.direction(VectorTaylor::constant(fixed));
        for (int k = 0; k <= 40; ++k) {
          const double s = -1 + k / 20.0, t = 0.5 * (t0 + t1) + 0.5 * (t1 - t0) * s;
          const Pose truth = seam.frame_at(t);
          // What is sampled is off by a trifle near the middle too.
          const double power = is_curve ? 1 : std::pow(s, 4);
          EXPECT_LE(off(frame.position(), s, truth.translation()),
                    frame.position().rest * power + 1e-11);
          EXPECT_LE(off(seen, s, truth.inverse() * fixed), seen.rest * power + 1e-11);
          EXPECT_LE(off(towards, s, truth.linear().transpose() * fixed),
                    towards.rest * power + 1e-11);
          for (int axis = 0; axis < 3; ++axis) {
            const VectorTaylor enclosed = frame.axis(axis);
            EXPECT_LE(off(enclosed, s, truth.linear().col(axis)), enclosed.rest * power + 1e-11);
          }
        }
        ++all;
        if (length > 0.1) continue;
        if (seen.rest < 1e-3) ++tight;
      }
    }
  }
  EXPECT_GT(tight, all / 3);
}

/// Cuts in order, each once: ends of pieces at their real times, and the knots of the law.
TEST(SeamBreaks, AreTheEndsOfPiecesAndTheKnotsOfTheLaw) {
  Dice dice(22);
  const Seam seam = any_seam(dice);
  EXPECT_EQ(seam_breaks(seam, 0.5, 2.5), (std::vector<double>{1, 2}));
  EXPECT_EQ(seam_breaks(seam, 1, 2), std::vector<double>{});
  const std::vector<double> cuts = seam_breaks(with_a_stop(seam), 0.5, 4);
  ASSERT_EQ(cuts.size(), 4U);
  EXPECT_NEAR(cuts[0], 1, 1e-12);
  EXPECT_EQ(cuts[1], 1.5);
  EXPECT_EQ(cuts[2], 2.5);
  EXPECT_EQ(cuts[3], 3);
}

}  // namespace
}  // namespace wristwise
