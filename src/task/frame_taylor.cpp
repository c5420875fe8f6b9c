#include "task/frame_taylor.hpp"

#include <algorithm>
#include <cmath>

#include "task/motion_piece.hpp"

namespace wristwise {

namespace {

/// The nominal time over [t0, t1], between two knots of the time law.
Taylor nominal_time(const Seam& seam, double t0, double t1) {
  const double middle = 0.5 * (t0 + t1);
  if (!seam.is_retimed()) return {{middle, 0.5 * (t1 - t0), 0, 0}, 0};
  const Trajectory& law = seam.seam_time();
  const std::vector<double>& times = law.times();
  if (middle <= times.front() || middle >= times.back())
    return Taylor::constant(law.evaluate(middle)[0]);
  const auto next = std::upper_bound(times.begin() + 1, times.end() - 1, middle);
  const auto i = static_cast<std::size_t>(next - times.begin()) - 1;
  const auto c = MotionPiece(times[i], times[i + 1], law.polynomials(i)).over(t0, t1).row(0).eval();
  return {{c[0], c[1], c[2], c[3]}, std::abs(c[4]) + 5 * std::abs(c[5])};
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

/// Null where the piece is a curve that can't be enclosed.
const EnclosedCurve* curve_of(const SeamPiece& piece) {
  return dynamic_cast<const EnclosedCurve*>(piece.curve.get());
}

EnclosedOrientation orientation_of(const SeamPiece& piece, const Taylor& fraction) {
  if (piece.kind == SeamPiece::Kind::curve) {
    const EnclosedCurve* curve = curve_of(piece);
    return curve ? curve->orientation(fraction) : any_orientation();
  }
  if (piece.kind == SeamPiece::Kind::arc)
    return {{piece.axis, piece.angle * fraction}, piece.from.linear(), {}};
  const Eigen::AngleAxisd turn(piece.from.linear().transpose() * piece.to.linear());
  return {{piece.from.linear() * turn.axis(), turn.angle() * fraction}, piece.from.linear(), {}};
}

std::vector<TaylorTurn> turns_back(const std::vector<EnclosedTurn>& turns) {
  std::vector<TaylorTurn> back;
  for (const EnclosedTurn& turn : turns) back.emplace_back(turn.axis, -1.0 * turn.angle);
  return back;
}

}  // namespace

FrameTaylor::FrameTaylor(const Seam& seam, double t0, double t1)
    : piece_(seam.piece_at(0.5 * (t0 + t1))),
      fraction_(fraction_of(seam, piece_, t0, t1)),
      orientation_(orientation_of(piece_, fraction_)),
      back_(orientation_.before.axis, -1.0 * orientation_.before.angle),
      back_after_(turns_back(orientation_.after)) {}

VectorTaylor FrameTaylor::position() const {
  if (piece_.kind == SeamPiece::Kind::curve) {
    const EnclosedCurve* curve = curve_of(piece_);
    return curve ? curve->position(fraction_) : anywhere();
  }
  const Eigen::Vector3d start = piece_.from.translation();
  if (piece_.kind == SeamPiece::Kind::arc) {
    const TaylorTurn turn(orientation_.before.axis, orientation_.before.angle);
    return VectorTaylor::constant(piece_.center) +
           turn * VectorTaylor::constant(start - piece_.center);
  }
  return VectorTaylor::constant(start) + along(piece_.to.translation() - start, fraction_);
}

VectorTaylor FrameTaylor::axis(int k) const {
  VectorTaylor axis = VectorTaylor::constant(Eigen::Vector3d::Unit(k));
  const auto& after = orientation_.after;
  for (auto turn = after.rbegin(); turn != after.rend(); ++turn)
    axis = TaylorTurn(turn->axis, turn->angle) * axis;
  return TaylorTurn(orientation_.before.axis, orientation_.before.angle) *
         (orientation_.start * axis);
}

VectorTaylor FrameTaylor::point(const VectorTaylor& in_base) const {
  const Eigen::Matrix3d to_start = piece_.from.linear().transpose();
  if (piece_.kind != SeamPiece::Kind::arc) return direction(in_base - position());
  const VectorTaylor turned_back = back_ * (in_base - VectorTaylor::constant(piece_.center));
  return to_start *
         (turned_back + VectorTaylor::constant(piece_.center - piece_.from.translation()));
}

VectorTaylor FrameTaylor::direction(const VectorTaylor& in_base) const {
  VectorTaylor result = orientation_.start.transpose() * (back_ * in_base);
  for (const TaylorTurn& turn : back_after_) result = turn * result;
  return result;
}

std::vector<double> seam_breaks(const Seam& seam, double t0, double t1) {
  std::vector<double> breaks;
  const auto add = [&](double t) {
    if (t > t0 && t < t1) breaks.push_back(t);
  };
  const double n0 = seam.nominal_time(t0), n1 = seam.nominal_time(t1);
  add(seam.start_time());
  const auto& pieces = seam.pieces();
  auto piece = std::upper_bound(pieces.begin(), pieces.end(), n0,
                                [](double n, const SeamPiece& of) { return n < of.end_time; });
  for (; piece != pieces.end() && piece->end_time <= n1; ++piece)
    add(seam.real_time(piece->end_time));
  if (seam.is_retimed()) {
    const std::vector<double>& knots = seam.seam_time().times();
    for (auto knot = std::upper_bound(knots.begin(), knots.end(), t0);
         knot != knots.end() && *knot < t1; ++knot)
      breaks.push_back(*knot);
    std::sort(breaks.begin(), breaks.end());
    breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
  }
  return breaks;
}

}  // namespace wristwise
