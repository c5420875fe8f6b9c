#include "kinematics/tcp_taylor.hpp"

namespace wristwise {

// The chain of (F5) from the TCP to the base: x <- O_j M_j(q_j) x.
PoseTaylor tcp_taylor(const Robot& robot, const MotionPiece::Polynomials& joints,
                      const std::array<bool, 3>& axes) {
  PoseTaylor tcp;
  tcp.position = VectorTaylor::constant(robot.tcp().translation());
  for (std::size_t k = 0; k < 3; ++k) {
    if (axes[k]) {
      tcp.axes[k] = VectorTaylor::constant(robot.tcp().linear().col(static_cast<Eigen::Index>(k)));
    }
  }
  for (int j = robot.joint_count(); j-- > 0;) {
    const Joint& joint = robot.joints()[static_cast<std::size_t>(j)];
    const Taylor value = polynomial_taylor(joints, j);
    const Eigen::Matrix3d origin = joint.origin.linear();
    if (joint.type == JointType::prismatic) {
      tcp.position = origin * (tcp.position + along(joint.axis, value));
      for (std::size_t k = 0; k < 3; ++k) {
        if (axes[k]) tcp.axes[k] = origin * tcp.axes[k];
      }
    } else {
      const TaylorTurn turn(joint.axis, value);
      tcp.position = origin * (turn * tcp.position);
      for (std::size_t k = 0; k < 3; ++k) {
        if (axes[k]) tcp.axes[k] = origin * (turn * tcp.axes[k]);
      }
    }
    tcp.position.c[0] += joint.origin.translation();
  }
  return tcp;
}

}  // namespace wristwise
