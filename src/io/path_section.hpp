#pragma once

#include "io/config_reader.hpp"
#include "task/seam_builder.hpp"

namespace wristwise {

/// What `path` says, before it is made into a task.
struct PathSection {
  SeamDescription seam;
  Pose part = Pose::Identity();  ///< of `frame`, in base
  SpeedPolicy speed_policy = SpeedPolicy::hold;
  double between_position = Task().between_position;  ///< m
  double between_angle = Task().between_angle;        ///< rad
};
PathSection read_path(const ConfigReader& reader, const Robot& robot);

/// The task, with the part moved by a motion given in the base frame.
Task task_after(const Pose& motion, const PathSection& path, const Robot& robot);

/// The tolerance box; of the keys in `others` it only knows that they exist.
ToleranceBox read_tolerance(const ConfigReader& reader, const std::vector<std::string>& others);

/// One entry of `segments`. @param part the frame of the part, in base
Segment read_segment(const ConfigReader& reader, const Pose& part, const ToleranceBox& tolerance,
                     const Robot& robot);

/// What `corners` says.
CornerOptions read_corners(const ConfigReader& reader);

/// A length, or a vector under the key `away` and perhaps a duration.
RunDescription read_run(const ConfigReader& reader, const std::string& away);

/// A file with the columns x, y, z (m), qw, qx, qy, qz and perhaps time (s), in the frame `part`.
PoseListSegment read_pose_list(const std::filesystem::path& file, const Pose& part);

}  // namespace wristwise
