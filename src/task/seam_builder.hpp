#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "task/corner_options.hpp"
#include "wristwise/robot.hpp"
#include "wristwise/seam.hpp"

namespace wristwise {

// Poses are in the base frame. `where` names the input in messages.

struct LineSegment {
  Pose from, to;
};
/// `from` turned rigidly about an axis through the center.
struct ArcSegment {
  Pose from;
  Eigen::Vector3d center;  ///< m
  Eigen::Vector3d axis;    ///< of any length but zero
  double angle;            ///< rad, right-handed
};
/// Poses joined by lines.
struct PoseListSegment {
  std::vector<Pose> poses;
  std::vector<double> times;       ///< s, increasing; empty: by the speed
  std::vector<std::string> where;  ///< one per pose
};
/// Joint waypoints, cut to the joint limits; moves between them are timed by the nominal postures.
struct JointListSegment {
  std::vector<JointBox> postures;
  std::vector<std::string> where;  ///< one per posture
};

struct Segment {
  std::variant<LineSegment, ArcSegment, PoseListSegment, JointListSegment> shape;
  ToleranceBox tolerance;
  std::string where;
};

/// Between rest and the weld speed, before or after the seam. Either straight on along its tangent
/// over a length, or from a point away from it (an approach, a retract).
struct RunDescription {
  double length = 0;                      ///< m
  std::optional<Eigen::Vector3d> away{};  ///< m, in the path frame of the seam's end
  std::optional<double> duration{};       ///< s, with `away`; else twice the time at weld speed
  std::string where;
};

/// The seam as the user describes it.
struct SeamDescription {
  std::vector<Segment> segments;
  std::optional<double> speed;    ///< m/s
  std::optional<double> spacing;  ///< m, the longest interval between waypoints
  std::optional<int> waypoints;   ///< of the whole seam, without run-in and run-out
  CornerOptions corners;
  std::optional<RunDescription> run_in, run_out;
  std::string where;
};

/// Joins the segments, treats their corners, gives them their times, cuts them into waypoints and
/// adds run-in and run-out.
/// @throws InvalidInput naming the segment: nothing to join, gaps, repeated waypoints, no speed,
/// corners that can't be treated as is asked for, a run-in to a joint waypoint.
Task build_task(const Robot& robot, const SeamDescription& description);

}  // namespace wristwise
