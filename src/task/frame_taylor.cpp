#include "task/frame_taylor.hpp"

#include <algorithm>

namespace wristwise {

namespace {

/// Fraction of the piece that is run, at constant speed; held at the ends.
Taylor fraction_of(const SeamPiece& piece, double t0, double t1) {
  const double duration = piece.end_time - piece.start_time;
  const double middle = (0.5 * (t0 + t1) - piece.start_time) / duration;
  if (middle <= 0) return Taylor::constant(0);
  if (middle >= 1) return Taylor::constant(1);
  return {{middle, 0.5 * (t1 - t0) / duration, 0, 0}, 0};
}

Eigen::AngleAxisd turn_of(const SeamPiece& piece) {
  if (piece.kind == SeamPiece::Kind::arc) return {piece.angle, piece.axis};
  const Eigen::AngleAxisd turn(piece.from.linear().transpose() * piece.to.linear());
  return {turn.angle(), piece.from.linear() * turn.axis()};
}

}  // namespace

FrameTaylor::FrameTaylor(const Seam& seam, double t0, double t1)
    : piece_(seam.piece_at(0.5 * (t0 + t1))),
      fraction_(fraction_of(piece_, t0, t1)),
      turn_(turn_of(piece_)),
      back_(turn_.axis(), -turn_.angle() * fraction_) {}

VectorTaylor FrameTaylor::position() const {
  const Eigen::Vector3d start = piece_.from.translation();
  if (piece_.kind == SeamPiece::Kind::arc) {
    const TaylorTurn turn(turn_.axis(), turn_.angle() * fraction_);
    return VectorTaylor::constant(piece_.center) +
           turn * VectorTaylor::constant(start - piece_.center);
  }
  return VectorTaylor::constant(start) + along(piece_.to.translation() - start, fraction_);
}

VectorTaylor FrameTaylor::axis(int k) const {
  const TaylorTurn turn(turn_.axis(), turn_.angle() * fraction_);
  return turn * VectorTaylor::constant(piece_.from.linear().col(k));
}

VectorTaylor FrameTaylor::point(const VectorTaylor& in_base) const {
  const Eigen::Matrix3d to_start = piece_.from.linear().transpose();
  if (piece_.kind != SeamPiece::Kind::arc) return direction(in_base - position());
  const VectorTaylor turned_back = back_ * (in_base - VectorTaylor::constant(piece_.center));
  return to_start *
         (turned_back + VectorTaylor::constant(piece_.center - piece_.from.translation()));
}

VectorTaylor FrameTaylor::direction(const VectorTaylor& in_base) const {
  return piece_.from.linear().transpose() * (back_ * in_base);
}

std::vector<double> seam_breaks(const Seam& seam, double t0, double t1) {
  std::vector<double> breaks;
  if (seam.start_time() > t0 && seam.start_time() < t1) breaks.push_back(seam.start_time());
  const auto& pieces = seam.pieces();
  auto piece = std::upper_bound(pieces.begin(), pieces.end(), t0,
                                [](double t, const SeamPiece& of) { return t < of.end_time; });
  for (; piece != pieces.end() && piece->end_time < t1; ++piece) breaks.push_back(piece->end_time);
  return breaks;
}

}  // namespace wristwise
