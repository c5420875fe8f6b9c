#pragma once

#include <vector>

#include "wristwise/inverse_kinematics.hpp"
#include "wristwise/robot.hpp"
#include "wristwise/seam.hpp"

namespace wristwise::app {

enum class SeamShape { line, arc };

constexpr double kTravelAngle = 0.174532925199432957, kWorkAngle = 0.5 * kTravelAngle;  // rad, +-

/// A seam to start from: where it is, and how the torch stands on it.
struct SeamPlace {
  Pose frame = Pose::Identity();          ///< of the seam's middle, in the part's link
  bool torch_down = true;                 ///< against the frame's z axis; else along it
  int axis = 1;                           ///< of the frame, along which a line runs: 0 x, 1 y, 2 z
  double length = 0;                      ///< m
  double angle = 3.14159265358979323846;  ///< rad, that an arc turns by
  JointVector posture;                    ///< at its start
};

/// m. An arc turns clockwise about the frame's z axis, from its -x axis.
double arc_radius(const SeamPlace& place);

/// The seam in the part's link, in a time of 1 s.
SeamPiece seam_piece(const SeamPlace& place, SeamShape shape);

/// Places that the robot reaches all along the seam, inside its joint limits and without a jump, by
/// asking its inverse kinematics. First come those with the torch straight down, in front of the
/// robot at about 0.6 of its reach (or just above a part that moves), then, and alone where the
/// chain cannot turn its torch every way, those around postures of its own.
/// @param most the number of places that is enough
std::vector<SeamPlace> reachable_places(const Robot& robot, const InverseKinematics& solver,
                                        SeamShape shape, std::size_t most);

}  // namespace wristwise::app
