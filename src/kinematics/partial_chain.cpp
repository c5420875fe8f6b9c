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
  struct Placement {
    int joint = -1;
    Pose pose = Pose::Identity();
  };
  Robot::Parts parts = robot.parts();
  parts.joints.clear();
  Placement at;
  std::vector<Placement> frames;  // of the robot's joints
  for (int j = 0; j < robot.joint_count(); ++j) {
    const Joint& joint = robot.joints()[static_cast<std::size_t>(j)];
    if (std::binary_search(held.begin(), held.end(), j)) {
      at.pose = at.pose * joint_transform(joint, posture[j]);
    } else {
      parts.joints.push_back(joint);
      parts.joints.back().origin = at.pose * joint.origin;
      at = {static_cast<int>(parts.joints.size()) - 1, Pose::Identity()};
    }
    frames.push_back(at);
  }
  parts.tcp = at.pose * robot.tcp();
  for (Link& link : parts.links) {
    if (link.joint < 0) continue;
    const Placement& frame = frames[static_cast<std::size_t>(link.joint)];
    link.pose = frame.pose * link.pose;
    link.joint = frame.joint;
  }
  return Robot(std::move(parts));
}

}  // namespace wristwise
