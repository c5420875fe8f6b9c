#pragma once

#include <vector>

#include "io/json_value.hpp"
#include "wristwise/joints.hpp"
#include "wristwise/pose.hpp"

namespace wristwise::json {

/// The double nearest to the value with so many decimals, which prints as short as it can; null
/// where it is not finite.
Json rounded(double value, int decimals);

Json array(const std::vector<double>& values, int decimals);
Json array(const Eigen::Vector3d& values, int decimals);

/// One array for each joint, over time.
Json by_joint(const std::vector<JointVector>& values, int decimals);

/// [x, y, z, qx, qy, qz, qw]
Json pose(const Pose& pose);

inline constexpr int kExact = 9;  ///< decimals of what is computed with: 1 nm
inline constexpr int kShown = 6;  ///< decimals of what is only shown: 1 um

}  // namespace wristwise::json
