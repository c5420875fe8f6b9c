#include "task/seam_runs.hpp"

#include <fmt/format.h>

#include <cmath>

#include "wristwise/error.hpp"

namespace wristwise {

namespace {

constexpr double kLeastLength = 1e-6;  // m

void check(const RunDescription& run, const SeamEnd& end) {
  const double length = run.away ? run.away->norm() : run.length;
  if (!std::isfinite(length) || length < kLeastLength)
    throw InvalidInput(run.where, fmt::format("{} m long", length), "a way to get up to speed on");
  if (run.duration && !(*run.duration > 0 && std::isfinite(*run.duration)))
    throw InvalidInput(run.where, fmt::format("a duration of {} s", *run.duration),
                       "a positive time");
  if (end.point.tangent.isZero(0))
    throw InvalidInput(run.where, "the seam turns on the spot there",
                       "a seam that moves at its end");
}

}  // namespace

RunPiece run_piece(RunCurve::Way way, const RunDescription& run, const SeamEnd& end) {
  check(run, end);
  PathPoint point = end.point;
  const Pose& seam = point.frame;
  RunPiece result;
  Eigen::Vector3d rest = seam.translation();
  if (run.away) {
    rest += seam.linear() * *run.away;
    result.duration = run.duration.value_or(2 * run.away->norm() / end.speed);
  } else {
    point.curvature.setZero();
    rest += (way == RunCurve::Way::in ? -run.length : run.length) * point.tangent;
    result.duration = 2 * run.length / end.speed;
  }
  SeamPiece& piece = result.piece;
  piece.kind = SeamPiece::Kind::curve;
  piece.curve = std::make_shared<const RunCurve>(way, point, end.speed, rest, result.duration);
  piece.from = way == RunCurve::Way::in ? piece.curve->frame_at(0) : seam;
  piece.to = way == RunCurve::Way::in ? seam : piece.curve->frame_at(1);
  return result;
}

}  // namespace wristwise
