#include "task/frame_taylor.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "task/motion_piece.hpp"

namespace wristwise {

namespace {

constexpr int kNodes = 8;          // of a curve that is sampled
constexpr double kTailMargin = 4;  // on its coefficients of the fourth order and above

/// Nominal time; the law's pieces are quintics, and it is held at its ends.
Taylor nominal_time(const Seam& seam, double t0, double t1) {
  const double middle = 0.5 * (t0 + t1);
  if (!seam.is_retimed()) return {{middle, 0.5 * (t1 - t0), 0, 0}, 0};
  const Trajectory& law = seam.seam_time();
  const auto& times = law.times();
  if (middle <= times.front() || middle >= times.back())
    return Taylor::constant(seam.nominal_time(middle));
  const auto after = std::upper_bound(times.begin() + 1, times.end() - 1, middle);
  const auto piece = static_cast<std::size_t>(after - times.begin()) - 1;
  const MotionPiece motion(times[piece], times[piece + 1], law.polynomials(piece));
  return polynomial_taylor(motion.over(t0, t1), 0);
}

/// Fraction of the piece that is run; held at the ends.
Taylor fraction_of(const Seam& seam, const SeamPiece& piece, double t0, double t1) {
  const double duration = piece.end_time - piece.start_time;
  const Taylor fraction =
      (1 / duration) * (nominal_time(seam, t0, t1) - Taylor::constant(piece.start_time));
  if (fraction.c[0] <= 0) return Taylor::constant(0);
  if (fraction.c[0] >= 1) return Taylor::constant(1);
  return fraction;
}

Eigen::AngleAxisd turn_of(const SeamPiece& piece) {
  if (piece.kind == SeamPiece::Kind::arc) return {piece.angle, piece.axis};
  const Eigen::AngleAxisd turn(piece.from.linear().transpose() * piece.to.linear());
  return {turn.angle(), piece.from.linear() * turn.axis()};
}

using Samples = Eigen::Matrix<double, kNodes, 1>;

/// Chebyshev nodes in (-1, 1).
Samples nodes() {
  Samples s;
  for (int i = 0; i < kNodes; ++i) s[i] = std::cos(3.14159265358979323846 * (i + 0.5) / kNodes);
  return s;
}

/// From values at the nodes to powers of s.
Eigen::Matrix<double, kNodes, kNodes> to_powers() {
  Eigen::Matrix<double, kNodes, kNodes> powers;
  const Samples s = nodes();
  for (int k = 0; k < kNodes; ++k) powers.col(k) = s.array().pow(k);
  return powers.inverse();
}

/// Four Taylor coefficients and a bound on the fourth, from the polynomial through the samples.
VectorTaylor through(const Eigen::Matrix<double, kNodes, 3>& values) {
  static const Eigen::Matrix<double, kNodes, kNodes> kToPowers = to_powers();
  const Eigen::Matrix<double, kNodes, 3> c = kToPowers * values;
  VectorTaylor f;
  double choose = 1;  // k over 4
  for (int k = 0; k < kNodes; ++k) {
    if (k < Taylor::kTerms) {
      f.c[static_cast<std::size_t>(k)] = c.row(k).transpose();
    } else {
      f.rest += kTailMargin * choose * c.row(k).norm();
      choose *= static_cast<double>(k + 1) / (k - 3);
    }
  }
  return f;
}

}  // namespace

FrameTaylor::FrameTaylor(const Seam& seam, double t0, double t1)
    : piece_(seam.piece_at(0.5 * (t0 + t1))),
      fraction_(fraction_of(seam, piece_, t0, t1)),
      turn_(turn_of(piece_)),
      back_(turn_.axis(), -turn_.angle() * fraction_) {
  const Eigen::Vector3d start = piece_.from.translation();
  if (piece_.kind == SeamPiece::Kind::curve) {
    sample(seam, t0, t1);
  } else if (piece_.kind == SeamPiece::Kind::arc) {
    const TaylorTurn turn(turn_.axis(), turn_.angle() * fraction_);
    position_ = VectorTaylor::constant(piece_.center) +
                turn * VectorTaylor::constant(start - piece_.center);
  } else {
    position_ = VectorTaylor::constant(start) + along(piece_.to.translation() - start, fraction_);
  }
}

void FrameTaylor::sample(const Seam& seam, double t0, double t1) {
  Eigen::Matrix<double, kNodes, 3> positions;
  std::array<Eigen::Matrix<double, kNodes, 3>, 3> axes;
  const Samples s = nodes();
  for (int i = 0; i < kNodes; ++i) {
    const Pose frame = seam.frame_at(0.5 * (t0 + t1) + 0.5 * (t1 - t0) * s[i]);
    positions.row(i) = frame.translation().transpose();
    for (int k = 0; k < 3; ++k) {
      axes[static_cast<std::size_t>(k)].row(i) = frame.linear().col(k).transpose();
    }
  }
  position_ = through(positions);
  for (std::size_t k = 0; k < 3; ++k) sampled_axes_[k] = through(axes[k]);
}

VectorTaylor FrameTaylor::axis(int k) const {
  if (piece_.kind == SeamPiece::Kind::curve) return sampled_axes_[static_cast<std::size_t>(k)];
  const TaylorTurn turn(turn_.axis(), turn_.angle() * fraction_);
  return turn * VectorTaylor::constant(piece_.from.linear().col(k));
}

VectorTaylor FrameTaylor::point(const VectorTaylor& in_base) const {
  const Eigen::Matrix3d to_start = piece_.from.linear().transpose();
  if (piece_.kind != SeamPiece::Kind::arc) return direction(in_base - position_);
  const VectorTaylor turned_back = back_ * (in_base - VectorTaylor::constant(piece_.center));
  return to_start *
         (turned_back + VectorTaylor::constant(piece_.center - piece_.from.translation()));
}

VectorTaylor FrameTaylor::direction(const VectorTaylor& in_base) const {
  if (piece_.kind == SeamPiece::Kind::curve)
    return {dot(sampled_axes_[0], in_base), dot(sampled_axes_[1], in_base),
            dot(sampled_axes_[2], in_base)};
  return piece_.from.linear().transpose() * (back_ * in_base);
}

std::vector<double> seam_breaks(const Seam& seam, double t0, double t1) {
  std::vector<double> breaks;
  const auto add = [&](double t) {
    if (t > t0 && t < t1) breaks.push_back(t);
  };
  add(seam.start_time());
  const auto& pieces = seam.pieces();
  const double from = seam.nominal_time(t0), to = seam.nominal_time(t1);
  auto piece = std::lower_bound(pieces.begin(), pieces.end(), from,
                                [](const SeamPiece& of, double t) { return of.end_time < t; });
  for (; piece != pieces.end() && piece->end_time <= to; ++piece)
    add(seam.real_time(piece->end_time));
  if (seam.is_retimed()) {
    const auto& knots = seam.seam_time().times();
    for (auto knot = std::upper_bound(knots.begin(), knots.end(), t0);
         knot != knots.end() && *knot < t1; ++knot) {
      add(*knot);
    }
  }
  std::sort(breaks.begin(), breaks.end());
  breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
  return breaks;
}

}  // namespace wristwise
