#pragma once

#include <Eigen/Geometry>
#include <string>

namespace wristwise {

/// A quaternion from a file, made a unit one.
/// @throws InvalidInput at `where` where its norm is off by more than 1e-3
Eigen::Quaterniond unit_quaternion(double w, double x, double y, double z,
                                   const std::string& where);

}  // namespace wristwise
