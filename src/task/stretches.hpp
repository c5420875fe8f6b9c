#pragma once

#include <optional>
#include <string>
#include <vector>

#include "wristwise/seam_description.hpp"

namespace wristwise {

/// A piece of the seam before it is timed and cut.
struct Stretch {
  SeamPiece piece;                     ///< its times are not set yet
  std::optional<double> duration;      ///< s, where the input prescribes it
  double least_duration = 0;           ///< s, of a move between two nominal postures
  std::optional<JointBox> end_joints;  ///< where it ends at a joint waypoint
  std::size_t segment = 0;
  std::string where;
  bool stands = false;  ///< the torch stands and turns, from rest to rest
  double end_rate = 1;  ///< speed where it ends, as a share of the weld speed
};

struct Stretches {
  double start_time = 0;  ///< s
  Pose start = Pose::Identity();
  std::optional<JointBox> start_joints;
  std::vector<Stretch> stretches;
};

/// Turns segments into stretches and joins them, with moves to and from joint waypoints.
Stretches lay_out(const Robot& robot, const std::vector<Segment>& segments);

/// s, at weld speed.
double nominal_duration(const Stretch& stretch, const SeamDescription& description);

}  // namespace wristwise
