#pragma once

#include <string>

#include "wristwise/robot.hpp"

namespace wristwise {

/// How joint values are shown: rad of a revolute joint, mm of a prismatic one.
struct JointUnit {
  std::string name;
  double factor = 1;  ///< of what is computed with
};

inline JointUnit joint_unit(const Joint& joint) {
  if (joint.type == JointType::prismatic) return {"mm", 1e3};
  return {"rad", 1};
}

/// "rad/s²"
inline std::string derivative_unit(const Joint& joint, int derivative) {
  constexpr const char* kPer[] = {"", "/s", "/s\u00b2", "/s\u00b3"};
  return joint_unit(joint).name + kPer[derivative];
}

}  // namespace wristwise
