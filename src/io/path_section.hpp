#pragma once

#include "io/config_reader.hpp"
#include "wristwise/export_options.hpp"
#include "wristwise/seam_description.hpp"

namespace wristwise {

/// What `path` says, before it is made into a task.
struct PathSection {
  SeamDescription seam;
  Pose part = Pose::Identity();  ///< of `frame`, in base
  SpeedPolicy speed_policy = SpeedPolicy::hold;
  double between_position = Task().between_position;  ///< m
  double between_angle = Task().between_angle;        ///< rad
};
/// @param exports says which joint is which axis of a robot program
PathSection read_path(const ConfigReader& reader, const Robot& robot, const ExportOptions& exports);

/// The task, with the part moved by a motion given in the base frame.
Task task_after(const Pose& motion, const PathSection& path, const Robot& robot);

/// The tolerance box; of the keys in `others` it only knows that they exist.
ToleranceBox read_tolerance(const ConfigReader& reader, const std::vector<std::string>& others);

/// What the entries of `segments` are read with.
struct SegmentContext {
  const Robot& robot;
  Pose part;                     ///< frame of the part, in base
  ToleranceBox tolerance;        ///< where a segment has none of its own
  const ExportOptions& exports;  ///< axes of robot programs
  bool has_speed = false;        ///< path.speed is given: it counts, not those of programs
};

/// One entry of `segments`: one segment, or those of a robot program.
std::vector<Segment> read_segments(const ConfigReader& reader, const SegmentContext& context);

/// The moves of a robot program: linear moves are lines between poses, the move before them says
/// where they start; joint moves to values of axes are joint waypoints.
/// @throws InvalidInput with file and line: what is not understood, joint moves to poses but for
/// the start of the lines, no moves.
std::vector<Segment> read_program_segments(const std::filesystem::path& file,
                                           const SegmentContext& context);

/// What `corners` says.
CornerOptions read_corners(const ConfigReader& reader);

/// A length, or a vector under the key `away` and perhaps a duration.
RunDescription read_run(const ConfigReader& reader, const std::string& away);

/// A CSV file of poses in the frame `part`, or a map of that file and what its columns are.
PoseListSegment read_pose_list(const ConfigReader& reader, const Pose& part);

}  // namespace wristwise
