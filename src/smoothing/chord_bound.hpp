#pragma once

#include "wristwise/robot.hpp"
#include "wristwise/trajectory.hpp"

namespace wristwise {

/// Bounds how far the TCP on a straight joint-space move strays from the line between the move's
/// ends (F52), for moves whose sliding joints stay as near to zero as they do along a path.
class ChordBound {
 public:
  ChordBound(const Robot& robot, const JointPath& path);

  /// m, for a move by `step` (rad or m)
  double position(const JointVector& step) const;
  /// rad, for a move that turns its joints by less than 1 rad in all
  double angle(const JointVector& step) const;

  /// The number of equal pieces that a move has to be cut into for either deviation to stay below
  /// the given one (m, rad) on each piece.
  double pieces(const JointVector& step, double position_deviation, double angle_deviation) const;

 private:
  JointVector turns_;  ///< 1 for a joint that turns, 0 for one that slides
  JointVector reach_;  ///< m per rad or m per m: bound on the TCP's speed per unit joint speed
};

}  // namespace wristwise
