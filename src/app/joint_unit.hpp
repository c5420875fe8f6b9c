#pragma once

#include <array>
#include <string>

#include "wristwise/robot.hpp"

namespace wristwise::app {

/// "rad/s^2": of a derivative of a joint's value, order 0 to 3.
inline std::string joint_unit(const Joint& joint, int order) {
  constexpr std::array<const char*, 4> kPerTime = {"", "/s", "/s^2", "/s^3"};
  return (joint.type == JointType::prismatic ? std::string("m") : std::string("rad")) +
         kPerTime[static_cast<std::size_t>(order)];
}

}  // namespace wristwise::app
