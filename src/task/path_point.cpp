#include "task/path_point.hpp"

namespace wristwise {

namespace {

constexpr double kLeastLength = 1e-9;  // m; below it a piece turns on the spot

/// The turn of the whole piece: axis times angle, base frame. Its rate is constant.
Eigen::Vector3d whole_turn(const SeamPiece& piece) {
  if (piece.kind == SeamPiece::Kind::arc) return piece.angle * piece.axis;
  const Eigen::AngleAxisd turn(piece.from.linear().transpose() * piece.to.linear());
  return turn.angle() * (piece.from.linear() * turn.axis());
}

}  // namespace

PathPoint path_point(const SeamPiece& piece, double fraction) {
  PathPoint point;
  point.frame = piece.frame_at(fraction);
  const double length = piece.length();
  if (length < kLeastLength) return point;
  point.turning = whole_turn(piece) / length;
  if (piece.kind == SeamPiece::Kind::arc) {
    const Eigen::Vector3d along = point.turning.cross(point.frame.translation() - piece.center);
    point.tangent = along.normalized();
    point.curvature = point.turning.cross(point.tangent);
  } else {
    point.tangent = (piece.to.translation() - piece.from.translation()) / length;
  }
  return point;
}

SeamPiece part_of(const SeamPiece& piece, double from, double to) {
  SeamPiece part = piece;
  part.from = piece.frame_at(from);
  part.to = piece.frame_at(to);
  part.angle = (to - from) * piece.angle;
  return part;
}

}  // namespace wristwise
