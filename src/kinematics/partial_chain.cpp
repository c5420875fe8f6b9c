#include "kinematics/partial_chain.hpp"

#include <algorithm>

namespace wristwise {

Pose joint_transform(const Joint& joint, double position) {
  if (joint.type == JointType::prismatic) {
    return joint.origin * Eigen::Translation3d(position * joint.axis);
  }
  return joint.origin * Eigen::AngleAxisd(position, joint.axis);
}

Robot with_held_joints(const Robot& robot, const std::vector<int>& held,
                       const JointVector& posture) {
  Robot::Parts parts;
  parts.name = robot.name();
  parts.base_link = robot.base_link();
  parts.part_link = robot.part_link();
  parts.tip_link = robot.tip_link();
  Pose before = Pose::Identity();
  for (int j = 0; j < robot.joint_count(); ++j) {
    const Joint& joint = robot.joints()[static_cast<std::size_t>(j)];
    if (std::binary_search(held.begin(), held.end(), j)) {
      before = before * joint_transform(joint, posture[j]);
    } else {
      parts.joints.push_back(joint);
      parts.joints.back().origin = before * joint.origin;
      before = Pose::Identity();
    }
  }
  parts.tcp = before * robot.tcp();
  return Robot(std::move(parts));
}

}  // namespace wristwise
