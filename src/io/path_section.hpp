#pragma once

#include "io/config_reader.hpp"
#include "task/seam_builder.hpp"

namespace wristwise {

/// The tolerance box; of the keys in `others` it only knows that they exist.
ToleranceBox read_tolerance(const ConfigReader& reader, const std::vector<std::string>& others);

/// One entry of `segments`. @param part the frame of the part, in base
Segment read_segment(const ConfigReader& reader, const Pose& part, const ToleranceBox& tolerance,
                     const Robot& robot);

/// A file with the columns x, y, z (m), qw, qx, qy, qz and perhaps time (s), in the frame `part`.
PoseListSegment read_pose_list(const std::filesystem::path& file, const Pose& part);

}  // namespace wristwise
