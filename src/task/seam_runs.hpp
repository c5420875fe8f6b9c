#pragma once

#include "task/path_point.hpp"
#include "task/run_curve.hpp"
#include "wristwise/seam_description.hpp"

namespace wristwise {

/// How the seam is passed at one of its ends.
struct SeamEnd {
  PathPoint point;
  double speed = 0;  ///< m/s
};

/// The piece that runs in to or out of the end of a seam; its times are not set, its duration is
/// given apart.
struct RunPiece {
  SeamPiece piece;
  double duration = 0;  ///< s
};

/// @throws InvalidInput where there is no way to run, or the seam's end has no direction.
RunPiece run_piece(RunCurve::Way way, const RunDescription& description, const SeamEnd& end);

}  // namespace wristwise
