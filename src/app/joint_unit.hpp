#pragma once

#include <string>

#include "wristwise/robot.hpp"

namespace wristwise::app {

/// Of a joint's value.
inline std::string joint_unit(const Joint& joint) {
  return joint.type == JointType::prismatic ? "m" : "rad";
}

}  // namespace wristwise::app
