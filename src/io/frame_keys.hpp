#pragma once

#include <string>

#include "wristwise/pose.hpp"

namespace wristwise {

/// A pose as a problem file has it, to 1e-9 m and rad.
struct FrameKeys {
  Eigen::Vector3d xyz;  ///< m
  Eigen::Vector3d rpy;  ///< rad
};
FrameKeys frame_keys(const Pose& pose);

/// "[0.1, 0, -2]"
std::string list_text(const Eigen::Vector3d& values);

/// "{xyz: [..], rpy: [..]}"
std::string frame_text(const Pose& pose);

}  // namespace wristwise
