// Enclosures of the path frame (F29) against dense samples of it, on all kinds of pieces.

#include "task/frame_taylor.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "seam_samples.hpp"

namespace wristwise {
namespace {

using test::describe;
using test::line;
using test::sliding_robot;
using Kind = CornerOptions::Kind;

constexpr int kSamples = 25;
constexpr double kRoundOff = 1e-11;

Eigen::Vector3d value(const VectorTaylor& f, double s) {
  return f.c[0] + s * (f.c[1] + s * (f.c[2] + s * f.c[3]));
}

/// Two lines or an arc and a line that meet at a corner; the frames turn along them and jump there.
Seam any_seam(std::mt19937& random, Kind kind) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto rotation = [&] {
    return Eigen::AngleAxisd(uniform(random),
                             Eigen::Vector3d(uniform(random), uniform(random), 1).normalized());
  };
  Pose start = Pose(Eigen::Translation3d(uniform(random), 0, 0) * rotation());
  Segment first;
  Pose corner;
  if (uniform(random) > 0) {
    corner = Pose(Eigen::Translation3d(start.translation().x() + 0.1, 0.02, 0.01) * rotation());
    first = line(start, corner);
  } else {
    const Eigen::Vector3d center = start.translation() + Eigen::Vector3d(0.05, 0.05, 0);
    const Eigen::AngleAxisd turn(1.2, Eigen::Vector3d(0.1, 0.2, 1).normalized());
    corner = Eigen::Translation3d(center) * turn * Eigen::Translation3d(-center) * start;
    first = {ArcSegment{start, center, turn.axis(), turn.angle()}, {}, "arc"};
  }
  Pose begin = corner;
  begin.linear() = rotation() * corner.linear();
  Pose end = begin;
  end.translation() += Eigen::Vector3d(0.02 * uniform(random), 0.08, 0.03);
  end.linear() = rotation() * begin.linear();
  SeamDescription description = describe({first, line(begin, end)});
  description.corners.kind = kind;
  description.corners.distance = 0.008;
  description.run_in.emplace();
  description.run_in->length = 0.01;
  description.run_out.emplace();
  description.run_out->away = Eigen::Vector3d(0.01, -0.01, -0.03);
  description.run_out->duration = 4;
  return build_task(sliding_robot(), description).seam;
}

/// What was enclosed holds at samples of the interval.
void expect_enclosed(const Seam& seam, double t0, double t1, std::mt19937& random) {
  const FrameTaylor frame(seam, t0, t1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const Eigen::Vector3d place(uniform(random), uniform(random), uniform(random));
  const VectorTaylor position = frame.position();
  const VectorTaylor seen = frame.point(VectorTaylor::constant(place));
  const VectorTaylor direction = frame.direction(VectorTaylor::constant(place));
  for (int i = 1; i < kSamples; ++i) {
    const double s = -1 + 2.0 * i / kSamples, t = 0.5 * (t0 + t1) + 0.5 * s * (t1 - t0);
    const Pose there = seam.frame_at(t);
    const double s4 = s * s * s * s;
    EXPECT_LE((value(position, s) - there.translation()).norm(), s4 * position.rest + kRoundOff)
        << t << " in " << t0 << " to " << t1;
    EXPECT_LE((value(seen, s) - there.inverse() * place).norm(), s4 * seen.rest + kRoundOff) << t;
    EXPECT_LE((value(direction, s) - there.linear().transpose() * place).norm(),
              s4 * direction.rest + kRoundOff)
        << t;
    for (int k = 0; k < 3; ++k) {
      const VectorTaylor axis = frame.axis(k);
      EXPECT_LE((value(axis, s) - there.linear().col(k)).norm(), s4 * axis.rest + kRoundOff) << t;
    }
  }
}

void expect_parts_enclosed(const Seam& seam, double t0, double t1, std::mt19937& random) {
  double from = t0;
  for (const double to : seam_breaks(seam, t0, t1)) {
    expect_enclosed(seam, from, to, random);
    from = to;
  }
  expect_enclosed(seam, from, t1, random);
}

TEST(FrameTaylor, EnclosesPiecesCornersAndRuns) {
  std::mt19937 random(11);
  for (const Kind kind : {Kind::keep, Kind::stop, Kind::blend}) {
    for (int trial = 0; trial < 30; ++trial) {
      const Seam seam = any_seam(random, kind);
      std::uniform_real_distribution<double> time(seam.start_time(), seam.end_time());
      for (int part = 0; part < 20; ++part) {
        const double t0 = time(random);
        const double t1 = std::min(t0 + 2 * std::pow(0.5, part % 6), seam.end_time());
        if (t1 > t0) expect_parts_enclosed(seam, t0, t1, random);
      }
    }
  }
}

/// Breaks are where the frame or the law changes its formula: corners in real time, knots.
TEST(FrameTaylor, BreaksAreInRealTime) {
  std::mt19937 random(12);
  const Seam seam = any_seam(random, Kind::stop);
  const auto breaks = seam_breaks(seam, seam.start_time() - 1, seam.end_time() + 1);
  for (const SeamPiece& piece : seam.pieces()) {
    const double end = seam.real_time(piece.end_time);
    EXPECT_TRUE(std::any_of(breaks.begin(), breaks.end(), [&](double t) {
      return std::abs(t - end) < 1e-9;
    })) << end;
  }
  EXPECT_TRUE(std::is_sorted(breaks.begin(), breaks.end()));
}

/// The remainder of a fourth derivative falls by 16 with half the interval.
TEST(FrameTaylor, RemaindersShrink) {
  std::mt19937 random(13);
  for (const Kind kind : {Kind::stop, Kind::blend}) {
    const Seam seam = any_seam(random, kind);
    for (const SeamPiece& piece : seam.pieces()) {
      const double t0 = seam.real_time(piece.start_time), t1 = seam.real_time(piece.end_time);
      const double start = t0 + 0.31 * (t1 - t0), wide = 0.02 * (t1 - t0);
      if (!seam_breaks(seam, start, start + wide).empty()) continue;
      const double before = FrameTaylor(seam, start, start + wide).position().rest;
      const double after = FrameTaylor(seam, start, start + 0.5 * wide).position().rest;
      if (before > 1e-14) {
        EXPECT_LT(after, before / 12);
      }
      EXPECT_LT(before, 1e-5);
    }
  }
}

}  // namespace
}  // namespace wristwise
