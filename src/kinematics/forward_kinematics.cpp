#include <cassert>

#include "wristwise/kinematics.hpp"

namespace wristwise {

// (F5) Pose of joint j in the base frame, after its own motion:
//   T_j = T_{j-1} O_j M_j(q_j),   T_{-1} = I,
// with O_j the joint's origin and M_j the turn about, or the shift along, its axis a_j. The axis in
// base is R_j a_j; a joint's own motion leaves it in place. The TCP is T_{n-1} times a constant.
void forward_kinematics(const Robot& robot, const JointVector& q, ChainPose& chain) {
  assert(q.size() == robot.joint_count());
  chain.joint_count = robot.joint_count();
  Pose frame = Pose::Identity();
  for (int j = 0; j < chain.joint_count; ++j) {
    const auto index = static_cast<std::size_t>(j);
    const Joint& joint = robot.joints()[index];
    frame = frame * joint.origin;
    chain.axes[index].noalias() = frame.linear() * joint.axis;
    if (joint.type == JointType::prismatic) {
      frame.translation() += q[j] * chain.axes[index];
    } else {
      frame.linear() =
          (frame.linear() * Eigen::AngleAxisd(q[j], joint.axis).toRotationMatrix()).eval();
    }
    chain.frames[index] = frame;
  }
  chain.tcp = frame * robot.tcp();
}

Pose tcp_pose(const Robot& robot, const JointVector& q) {
  ChainPose chain;
  forward_kinematics(robot, q, chain);
  return chain.tcp;
}

namespace {

Eigen::Vector3d linear_column(const Robot& robot, const ChainPose& chain, std::size_t joint,
                              const Eigen::Vector3d& point) {
  if (robot.joints()[joint].type == JointType::prismatic) return chain.axes[joint];
  return chain.axes[joint].cross(point - chain.frames[joint].translation());
}

}  // namespace

// (F6) Column j of the geometric Jacobian for a point x that joint j moves:
//   revolute (a_j x (x - o_j), a_j),   prismatic (a_j, 0),
// a_j the axis and o_j the joint's origin in base.
Jacobian geometric_jacobian(const Robot& robot, const ChainPose& chain) {
  Jacobian jacobian(6, chain.joint_count);
  for (int j = 0; j < chain.joint_count; ++j) {
    const auto index = static_cast<std::size_t>(j);
    const bool turns = robot.joints()[index].type != JointType::prismatic;
    jacobian.col(j).head<3>() = linear_column(robot, chain, index, chain.tcp.translation());
    jacobian.col(j).tail<3>() = turns ? chain.axes[index] : Eigen::Vector3d::Zero();
  }
  return jacobian;
}

PointJacobian point_jacobian(const Robot& robot, const ChainPose& chain, int joint,
                             const Eigen::Vector3d& point) {
  PointJacobian jacobian = PointJacobian::Zero(3, chain.joint_count);
  for (int j = 0; j <= joint; ++j) {
    jacobian.col(j) = linear_column(robot, chain, static_cast<std::size_t>(j), point);
  }
  return jacobian;
}

}  // namespace wristwise
