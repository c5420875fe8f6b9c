#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>

namespace wristwise {

/// What a limits file says about one joint; rad or m, s.
struct JointLimits {
  std::optional<std::pair<double, double>> position;  ///< lower, upper
  std::optional<double> velocity;
  std::optional<double> acceleration;
  std::optional<double> jerk;
};

/// Reads MoveIt's joint_limits.yaml, by joint name.
/// @throws InvalidInput with file, line, joint and key.
std::map<std::string, JointLimits> read_joint_limits(const std::filesystem::path& file);

}  // namespace wristwise
