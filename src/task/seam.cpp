#include "wristwise/seam.hpp"

#include <algorithm>
#include <cmath>

#include "wristwise/error.hpp"

namespace wristwise {

namespace {

constexpr double kTimeTolerance = 1e-9;  // s, of the joint between two pieces
constexpr double kRoundOff = 1e-13;      // relative, of a time that is worked out

bool is_finite(const SeamPiece& piece) {
  return piece.from.matrix().allFinite() && piece.to.matrix().allFinite() &&
         piece.center.allFinite() && piece.axis.allFinite() && std::isfinite(piece.angle) &&
         std::isfinite(piece.start_time) && std::isfinite(piece.end_time);
}

Pose turned_frame(const SeamPiece& piece, double fraction) {
  const Eigen::AngleAxisd turn(fraction * piece.angle, piece.axis);
  return Eigen::Translation3d(piece.center) * turn * Eigen::Translation3d(-piece.center) *
         piece.from;
}

Pose straight_frame(const SeamPiece& piece, double fraction) {
  const Eigen::AngleAxisd turn(piece.from.linear().transpose() * piece.to.linear());
  Pose frame = Pose::Identity();
  frame.linear() = piece.from.linear() *
                   Eigen::AngleAxisd(fraction * turn.angle(), turn.axis()).toRotationMatrix();
  frame.translation() =
      piece.from.translation() + fraction * (piece.to.translation() - piece.from.translation());
  return frame;
}

}  // namespace

double SeamPiece::length() const {
  if (kind == Kind::curve) return curve->length();
  if (kind != Kind::arc) return (to.translation() - from.translation()).norm();
  const Eigen::Vector3d arm = from.translation() - center;
  return std::abs(angle) * axis.cross(arm).norm();
}

Pose SeamPiece::frame_at(double fraction) const {
  if (fraction <= 0) return from;
  if (fraction >= 1) return to;
  if (kind == Kind::curve) return curve->frame_at(fraction);
  return kind == Kind::arc ? turned_frame(*this, fraction) : straight_frame(*this, fraction);
}

Seam::Seam(std::vector<SeamPiece> pieces) : pieces_(std::move(pieces)) {
  if (pieces_.empty()) throw InvalidInput("seam", "no pieces", "at least one");
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const std::string where = "seam piece " + std::to_string(i);
    if (!is_finite(pieces_[i])) throw InvalidInput(where, "not finite");
    if (pieces_[i].kind == SeamPiece::Kind::curve && !pieces_[i].curve)
      throw InvalidInput(where, "a curve without its course");
    if (pieces_[i].end_time <= pieces_[i].start_time)
      throw InvalidInput(where, "does not end after it starts", "an increasing time");
    if (i > 0 && std::abs(pieces_[i].start_time - pieces_[i - 1].end_time) > kTimeTolerance)
      throw InvalidInput(where, "does not start when the piece before it ends");
  }
}

double Seam::length() const {
  double sum = 0;
  for (const SeamPiece& piece : pieces_) sum += piece.length();
  return sum;
}

const SeamPiece& Seam::piece_at_nominal(double nominal) const {
  if (pieces_.empty()) throw InvalidInput("seam", "no pieces", "at least one");
  const double reached = nominal - kRoundOff * std::max(1.0, std::abs(nominal));
  const auto found =
      std::lower_bound(pieces_.begin(), pieces_.end(), reached,
                       [](const SeamPiece& piece, double time) { return piece.end_time < time; });
  return found == pieces_.end() ? pieces_.back() : *found;
}

const SeamPiece& Seam::piece_at(double t) const { return piece_at_nominal(nominal_time(t)); }

Pose Seam::frame_at(double t) const {
  const double nominal = nominal_time(t);
  const SeamPiece& piece = piece_at_nominal(nominal);
  return piece.frame_at((nominal - piece.start_time) / (piece.end_time - piece.start_time));
}

}  // namespace wristwise
