#pragma once

#include <array>

#include "wristwise/robot.hpp"
#include "wristwise/visibility.hpp"

namespace WRISTWISE_PUBLIC wristwise {

/// Where every joint of the chain is at one posture, in the base frame.
struct ChainPose {
  int joint_count = 0;                           ///< of the entries below that are used
  std::array<Pose, kMaxJoints> frames;           ///< of each joint, after its own motion
  std::array<Eigen::Vector3d, kMaxJoints> axes;  ///< unit, in base
  Pose tcp;                                      ///< of the TCP

  /// Frame of joint `joint`; the base (identity) for -1.
  Pose frame(int joint) const {
    return joint < 0 ? Pose::Identity() : frames[static_cast<std::size_t>(joint)];
  }
};

/// Forward kinematics of the whole chain (F5).
/// @param robot n joints
/// @param q n values, rad or m; inside the limits or not
/// @param chain receives the frames
void forward_kinematics(const Robot& robot, const JointVector& q, ChainPose& chain);

/// Pose of the TCP in the base frame (F5); q has n values, rad or m.
Pose tcp_pose(const Robot& robot, const JointVector& q);

/// Geometric Jacobian of the TCP in the base frame, 6 x n (F6).
Jacobian geometric_jacobian(const Robot& robot, const ChainPose& chain);

/// Jacobian of a point (m, base frame) that is fixed to joint `joint`'s frame (F6); zero for -1.
PointJacobian point_jacobian(const Robot& robot, const ChainPose& chain, int joint,
                             const Eigen::Vector3d& point);

}  // namespace wristwise
