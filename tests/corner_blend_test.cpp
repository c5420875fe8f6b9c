#include "task/corner_blend.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace wristwise {
namespace {

constexpr double kDegree = 0.017453292519943295;

Eigen::Vector3d random_vector(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return {normal(random), normal(random), normal(random)};
}

Eigen::Matrix3d random_rotation(std::mt19937& random) {
  return Eigen::AngleAxisd(std::uniform_real_distribution<double>(-3, 3)(random),
                           random_vector(random).normalized())
      .toRotationMatrix();
}

/// Two pieces of 0.1 m that meet at the origin, lines or arcs, the frame turning along them.
struct Meeting {
  SeamPiece before, after;
};

/// An arc of 0.1 m with the given tangent at the origin, where it starts (way 1) or ends (way -1).
SeamPiece arc_at_origin(const Eigen::Vector3d& tangent, const Eigen::Vector3d& side, double radius,
                        const Eigen::Matrix3d& rotation, int way) {
  const Eigen::Vector3d inward = tangent.cross(side).cross(tangent).normalized();
  SeamPiece piece;
  piece.kind = SeamPiece::Kind::arc;
  piece.center = radius * inward;
  piece.axis = tangent.cross(inward);  // turning about it moves the origin along the tangent
  piece.angle = 0.1 / radius;
  Pose at = Pose::Identity();
  at.linear() = rotation;
  const Eigen::AngleAxisd turn(way * piece.angle, piece.axis);
  const Pose other =
      Eigen::Translation3d(piece.center) * turn * Eigen::Translation3d(-piece.center) * at;
  piece.from = way > 0 ? at : other;
  piece.to = way > 0 ? other : at;
  return piece;
}

SeamPiece line_at_origin(const Eigen::Vector3d& tangent, const Eigen::Matrix3d& rotation,
                         const Eigen::Matrix3d& far_rotation, int way) {
  SeamPiece piece;
  Pose at = Pose::Identity(), far = Pose::Identity();
  at.linear() = rotation;
  far.linear() = far_rotation;
  far.translation() = way * 0.1 * tangent;
  piece.from = way > 0 ? at : far;
  piece.to = way > 0 ? far : at;
  return piece;
}

SeamPiece random_piece(std::mt19937& random, const Eigen::Vector3d& tangent,
                       const Eigen::Matrix3d& rotation, int way) {
  std::uniform_real_distribution<double> share(0, 1);
  if (share(random) < 0.5)
    return arc_at_origin(tangent, random_vector(random), 0.05 + 0.2 * share(random), rotation, way);
  const Eigen::AngleAxisd turn(0.3 * share(random), random_vector(random).normalized());
  return line_at_origin(tangent, rotation, turn * rotation, way);
}

Meeting random_meeting(std::mt19937& random, double bend, double turn) {
  const Eigen::Vector3d first = random_vector(random).normalized();
  const Eigen::Vector3d axis = first.cross(random_vector(random)).normalized();
  const Eigen::Vector3d second = Eigen::AngleAxisd(bend, axis) * first;
  const Eigen::Matrix3d rotation = random_rotation(random);
  const Eigen::Matrix3d turned =
      Eigen::AngleAxisd(turn, random_vector(random).normalized()) * rotation;
  return {random_piece(random, first, rotation, -1), random_piece(random, second, turned, 1)};
}

/// Rate of turn per fraction, base frame, by central differences.
Eigen::Vector3d turn_rate(const SeamCurve& curve, double f, double h) {
  const Eigen::AngleAxisd turn(curve.frame_at(f + h).linear() *
                               curve.frame_at(f - h).linear().transpose());
  return turn.angle() / (2 * h) * turn.axis();
}

TEST(PathPoint, IsThatOfNumericDerivatives) {
  std::mt19937 random(5);
  for (int trial = 0; trial < 100; ++trial) {
    const Meeting meeting = random_meeting(random, 1, 0.5);
    for (const SeamPiece& piece : {meeting.before, meeting.after}) {
      EXPECT_NEAR(piece.length(), 0.1, 1e-12);
      for (const double f : {0.2, 0.5, 0.9}) {
        const PathPoint point = path_point(piece, f);
        const double h = 1e-4, step = h * piece.length();
        const Eigen::Vector3d left = piece.frame_at(f - h).translation(),
                              right = piece.frame_at(f + h).translation();
        EXPECT_LT((point.tangent - (right - left) / (2 * step)).norm(), 1e-7);
        const Eigen::Vector3d middle = point.frame.translation();
        EXPECT_LT((point.curvature - (left - 2 * middle + right) / (step * step)).norm(), 1e-3);
        const Eigen::AngleAxisd turn(piece.frame_at(f + h).linear() *
                                     piece.frame_at(f - h).linear().transpose());
        EXPECT_LT((point.turning - turn.angle() / (2 * step) * turn.axis()).norm(), 1e-6);
      }
    }
  }
}

TEST(PathPoint, PartOfAPieceIsThePieceThere) {
  std::mt19937 random(6);
  for (int trial = 0; trial < 50; ++trial) {
    const Meeting meeting = random_meeting(random, 1, 0.5);
    for (const SeamPiece& piece : {meeting.before, meeting.after}) {
      const SeamPiece part = part_of(piece, 0.25, 0.75);
      EXPECT_NEAR(part.length(), 0.5 * piece.length(), 1e-14);
      for (const double f : {0.0, 0.3, 1.0})
        EXPECT_LT((part.frame_at(f).matrix() - piece.frame_at(0.25 + 0.5 * f).matrix()).norm(),
                  1e-13);
    }
  }
}

/// A turn of 90 deg whose curve is known: points of the Bezier curve written out by hand, the
/// length by a polygon.
TEST(CornerBlend, OfARightAngle) {
  PathPoint from, to;
  from.tangent = Eigen::Vector3d::UnitX();
  from.frame.translation() = Eigen::Vector3d(-0.01, 0, 0);
  to.tangent = Eigen::Vector3d::UnitY();
  to.frame.translation() = Eigen::Vector3d(0, 0.01, 0);
  const CornerBlend blend(from, to, 0.01);
  const auto point = [](double u) {
    const double v = 1 - u;
    const double x = -0.01 * std::pow(v, 5) - 0.005 * 5 * u * std::pow(v, 4);
    const double y = 0.01 * std::pow(u, 5) + 0.005 * 5 * v * std::pow(u, 4);
    return Eigen::Vector3d(x, y, 0);
  };
  double length = 0;
  std::vector<double> reached{0};
  constexpr int kSides = 200000;
  for (int i = 0; i < kSides; ++i) {
    length += (point(static_cast<double>(i + 1) / kSides) - point(static_cast<double>(i) / kSides))
                  .norm();
    reached.push_back(length);
  }
  EXPECT_NEAR(blend.length(), length, 1e-10);
  for (int i = 0; i <= kSides; i += kSides / 50) {
    const double f = reached[static_cast<std::size_t>(i)] / length;
    EXPECT_LT((blend.frame_at(f).translation() - point(static_cast<double>(i) / kSides)).norm(),
              1e-10);
  }
  EXPECT_LT((blend.frame_at(0.5).translation() - point(0.5)).norm(), 1e-12);
}

TEST(CornerBlend, RunsAtConstantSpeed) {
  std::mt19937 random(7);
  for (int trial = 0; trial <= 17; ++trial) {
    const double bend = kDegree * 10 * trial;
    const Meeting meeting = random_meeting(random, bend, 1);
    const CornerBlend blend(path_point(part_of(meeting.before, 0, 0.9), 1),
                            path_point(part_of(meeting.after, 0.1, 1), 0), 0.01);
    double polygon = 0;
    constexpr int kSides = 20000;
    for (int i = 0; i < kSides; ++i) {
      const double f = static_cast<double>(i) / kSides, h = 1.0 / kSides;
      const double side =
          (blend.frame_at(f + h).translation() - blend.frame_at(f).translation()).norm();
      polygon += side;
      // A chord is shorter than its arc by kappa^2 arc^3 / 24.
      EXPECT_NEAR(side * kSides / blend.length(), 1, bend > 2.6 ? 1e-4 : 1e-6) << trial << " " << f;
    }
    EXPECT_NEAR(polygon, blend.length(), bend > 2.6 ? 1e-7 : 1e-9);
  }
}

TEST(CornerBlend, TakesOverPositionTangentCurvatureAndTurning) {
  std::mt19937 random(8);
  for (int trial = 0; trial < 100; ++trial) {
    const Meeting meeting = random_meeting(random, 0.02 * trial, 0.015 * trial);
    const PathPoint from = path_point(meeting.before, 0.9), to = path_point(meeting.after, 0.1);
    const CornerBlend blend(from, to, 0.01);
    const double length = blend.length();
    EXPECT_LT((blend.frame_at(0).matrix() - from.frame.matrix()).norm(), 1e-13);
    EXPECT_LT((blend.frame_at(1).matrix() - to.frame.matrix()).norm(), 1e-13);
    // One-sided differences of second order; the frames go on as a cubic in f at the ends.
    const double h = 1e-3;
    for (const bool at_end : {false, true}) {
      const PathPoint& point = at_end ? to : from;
      const double side = at_end ? -1 : 1, f = at_end ? 1 : 0;
      const auto position = [&](int k) -> Eigen::Vector3d {
        return blend.frame_at(f + side * k * h).translation();
      };
      const Eigen::Vector3d slope =
          side * (-3 * position(0) + 4 * position(1) - position(2)) / (2 * h * length);
      const Eigen::Vector3d bend =
          (2 * position(0) - 5 * position(1) + 4 * position(2) - position(3)) /
          (h * h * length * length);
      EXPECT_LT((slope - point.tangent).norm(), 2e-4) << trial;
      EXPECT_LT((bend - point.curvature).norm(), 0.05 * (1 + point.curvature.norm())) << trial;
      EXPECT_LT((turn_rate(blend, f + side * h, h) / length - point.turning).norm(), 0.05) << trial;
    }
  }
}

/// Without turning of the pieces the frame turns about one axis, by a smooth step.
TEST(CornerBlend, FrameTurnsAboutOneAxis) {
  PathPoint from, to;
  from.tangent = Eigen::Vector3d::UnitX();
  from.frame.translation() = Eigen::Vector3d(-0.01, 0, 0);
  to.tangent = Eigen::Vector3d::UnitY();
  to.frame.translation() = Eigen::Vector3d(0, 0.01, 0);
  to.frame.linear() = Eigen::AngleAxisd(1.5, Eigen::Vector3d(1, 2, 2) / 3).toRotationMatrix();
  const CornerBlend blend(from, to, 0.01);
  double last = 0;
  for (double f = 0.05; f < 1; f += 0.05) {
    const Eigen::AngleAxisd turn(blend.frame_at(f).linear());
    EXPECT_NEAR(turn.axis().dot(Eigen::Vector3d(1, 2, 2) / 3), 1, 1e-12);
    EXPECT_GT(turn.angle(), last);
    last = turn.angle();
    const Eigen::AngleAxisd mirrored(blend.frame_at(1 - f).linear());
    EXPECT_NEAR(turn.angle() + mirrored.angle(), 1.5, 1e-12);
  }
}

}  // namespace
}  // namespace wristwise
