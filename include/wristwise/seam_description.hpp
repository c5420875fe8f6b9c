#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "wristwise/corner_options.hpp"
#include "wristwise/robot.hpp"
#include "wristwise/seam.hpp"
#include "wristwise/visibility.hpp"

namespace WRISTWISE_PUBLIC wristwise {

// Poses are in the base frame. `where` names the input in messages; empty: by its number.

/// Straight, turning at a constant rate about one axis.
struct LineSegment {
  Pose from;  ///< path frame, in base, m
  Pose to;    ///< path frame, in base, m
};
/// `from` turned rigidly about an axis through the center.
struct ArcSegment {
  Pose from;               ///< path frame, in base, m
  Eigen::Vector3d center;  ///< m
  Eigen::Vector3d axis;    ///< of any length but zero
  double angle;            ///< rad, right-handed
};
/// Poses joined by lines.
struct PoseListSegment {
  std::vector<Pose> poses;              ///< path frames, in base, m
  std::vector<double> times = {};       ///< s, increasing; empty: by the speed
  std::vector<std::string> where = {};  ///< one per pose, or none
};
/// Joint waypoints, cut to the joint limits; moves between them are timed by the nominal postures.
struct JointListSegment {
  std::vector<JointBox> postures;       ///< rad or m, one value or range for each joint
  std::vector<std::string> where = {};  ///< one per posture, or none
};

/// A part of the seam. Each begins where the one before it ends.
struct Segment {
  std::variant<LineSegment, ArcSegment, PoseListSegment, JointListSegment>
      shape;                    ///< of one of these kinds
  ToleranceBox tolerance = {};  ///< of its waypoints, and between them
  std::string where = {};       ///< names it in messages; empty: its number
};

/// Between rest and the weld speed, before or after the seam. Either straight on along its tangent
/// over a length, or from a point away from it (an approach, a retract).
struct RunDescription {
  double length = 0;                      ///< m
  std::optional<Eigen::Vector3d> away{};  ///< m, in the path frame of the seam's end
  std::optional<double> duration{};       ///< s, with `away`; else twice the time at weld speed
  std::string where = {};                 ///< names it in messages
};

/// A seam as a welder describes it; what `path` of a problem file says.
struct SeamDescription {
  std::vector<Segment> segments;          ///< one or more, in order
  std::optional<double> speed;            ///< m/s; needed where not every pose has a time
  std::optional<double> spacing;          ///< m, the longest interval between waypoints; or:
  std::optional<int> waypoints;           ///< of the whole seam, without run-in and run-out
  CornerOptions corners;                  ///< what happens where the direction jumps
  std::optional<RunDescription> run_in;   ///< from rest; none: it begins at weld speed
  std::optional<RunDescription> run_out;  ///< to rest; none: it ends at weld speed
  std::string where;                      ///< names it in messages
};

/// Joins the segments, treats their corners, gives them their times, cuts them into waypoints and
/// adds run-in and run-out.
/// @throws InvalidInput naming the segment: nothing to join, gaps, repeated waypoints, no speed,
/// values that are not finite, lists of different sizes, a tolerance that is none, corners that
/// can't be treated as is asked for, a run-in to a joint waypoint.
Task build_task(const Robot& robot, const SeamDescription& description);

}  // namespace wristwise
