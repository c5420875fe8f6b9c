#pragma once

#include "wristwise/kinematics.hpp"
#include "wristwise/seam.hpp"
#include "wristwise/trajectory.hpp"

namespace wristwise {

/// The TCP path that a joint path draws, its points joined by straight joint-space moves.
struct DrawnPath {
  JointPath path;           ///< with points added on moves that are long for the tolerance
  std::vector<Pose> poses;  ///< of the TCP, one for each point
  Seam seam;                ///< lines that stay within a share of the tolerance of the moves
};

/// The share of the tolerance by which the seam's lines may miss the moves (F52).
inline constexpr double kChordShare = 0.05;

/// @param position, angle the tolerance (m, rad)
/// @throws InvalidInput where that would take millions of lines
DrawnPath draw_path(const Robot& robot, const JointPath& path, double position, double angle);

}  // namespace wristwise
