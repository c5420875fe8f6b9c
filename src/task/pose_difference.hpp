#pragma once

#include <Eigen/Geometry>

#include "wristwise/pose.hpp"

namespace wristwise {

/// rad, of the rotation from one to the other
inline double turn_between(const Pose& a, const Pose& b) {
  return Eigen::AngleAxisd(a.linear().transpose() * b.linear()).angle();
}

/// Whether they are at most `position` (m) and `angle` (rad) apart.
inline bool is_near(const Pose& a, const Pose& b, double position, double angle) {
  return (a.translation() - b.translation()).norm() <= position && turn_between(a, b) <= angle;
}

}  // namespace wristwise
