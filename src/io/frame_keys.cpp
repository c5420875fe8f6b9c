#include "io/frame_keys.hpp"

#include <fmt/format.h>

#include <cmath>

namespace wristwise {

namespace {

constexpr double kPerUnit = 1e9;

Eigen::Vector3d rounded(const Eigen::Vector3d& values) {
  return values.unaryExpr(
      [](double value) { return std::round(value * kPerUnit) / kPerUnit + 0.0; });
}

}  // namespace

FrameKeys frame_keys(const Pose& pose) {
  // (Rz(yaw) Ry(pitch) Rx(roll))^T = Rx(-roll) Ry(-pitch) Rz(-yaw), the sequence of (F1)
  return {rounded(pose.translation()), rounded(-euler_angles(pose.linear().transpose()))};
}

std::string list_text(const Eigen::Vector3d& values) {
  return fmt::format("[{}, {}, {}]", values.x(), values.y(), values.z());
}

std::string frame_text(const Pose& pose) {
  const FrameKeys keys = frame_keys(pose);
  return "{xyz: " + list_text(keys.xyz) + ", rpy: " + list_text(keys.rpy) + "}";
}

}  // namespace wristwise
