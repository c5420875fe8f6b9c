#pragma once

#include <string>
#include <vector>

#include "wristwise/robot.hpp"

namespace wristwise::app {

inline std::vector<std::string> joint_names(const Robot& robot) {
  std::vector<std::string> names;
  for (const Joint& joint : robot.joints()) names.push_back(joint.name);
  return names;
}

}  // namespace wristwise::app
