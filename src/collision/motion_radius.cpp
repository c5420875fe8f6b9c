#include "collision/motion_radius.hpp"

#include <algorithm>

#include "collision/placed_shape.hpp"

namespace wristwise {

// (F9) Let joint j lie between the bodies, and n be the normal and p_a, p_b the nearest points of
// the pair. The distance changes at the rate
//   revolute:  n.(a_j x (p_b - o_j)) = n.(a_j x (p_a - o_j)),   because p_b - p_a is along n,
//   prismatic: n.a_j,
// so that its size is at most the lesser of the largest distances that a point of shape a, and a
// point of shape b, can have from the axis; or 1. The distance function is continuous and these
// rates bound it wherever it is differentiable, hence for finite steps as well.
//
// Where a shape can be, seen from joint j, is held in a ball that is carried from the shape's own
// joint towards joint j. A revolute joint on the way sweeps a ball round its axis: into one centred
// on the axis, larger by the centre's distance from it. A prismatic joint sweeps it along its axis:
// into one centred at mid-travel, larger by half the travel.

namespace {

BoundingBall ball_of(const Shape& shape) {
  const BoundingBall local = bounding_ball(shape.geometry);
  return {shape.pose * local.center, local.radius};
}

Eigen::Vector3d along(const Joint& joint, const Eigen::Vector3d& point) {
  return joint.axis.dot(point) * joint.axis;
}

/// @param direction +1 for what the joint carries, -1 for what stands still, seen from beyond it
BoundingBall swept(const Joint& joint, const BoundingBall& ball, double direction) {
  if (joint.type == JointType::prismatic) {
    const double middle = (joint.lower + joint.upper) / 2;
    return {ball.center + direction * middle * joint.axis,
            ball.radius + (joint.upper - joint.lower) / 2};
  }
  const Eigen::Vector3d on_axis = along(joint, ball.center);
  return {on_axis, ball.radius + (ball.center - on_axis).norm()};
}

double reach_from_axis(const Joint& joint, const BoundingBall& ball) {
  return (ball.center - along(joint, ball.center)).norm() + ball.radius;
}

const Joint& joint_at(const Robot& robot, int j) {
  return robot.joints()[static_cast<std::size_t>(j)];
}

/// The ball, given in the frame of joint `from`, as seen from the frame of joint `to` >= from
/// before that joint's own motion.
BoundingBall seen_from_beyond(const Robot& robot, BoundingBall ball, int from, int to) {
  for (int j = from + 1; j <= to; ++j) {
    ball.center = joint_at(robot, j).origin.inverse(Eigen::Isometry) * ball.center;
    if (j < to) ball = swept(joint_at(robot, j), ball, -1);
  }
  return ball;
}

}  // namespace

JointVector motion_radius(const Robot& robot, int joint_a, const Shape& shape_a, int joint_b,
                          const Shape& shape_b) {
  const bool a_is_near = joint_a <= joint_b;
  const int near = std::min(joint_a, joint_b);
  const int far = std::max(joint_a, joint_b);
  const BoundingBall near_ball = ball_of(a_is_near ? shape_a : shape_b);
  JointVector radius = reach_of(robot, far, a_is_near ? shape_b : shape_a, near);
  for (int j = far; j > near; --j) {
    const Joint& joint = joint_at(robot, j);
    if (joint.type == JointType::prismatic) continue;
    radius[j] =
        std::min(radius[j], reach_from_axis(joint, seen_from_beyond(robot, near_ball, near, j)));
  }
  return radius;
}

JointVector reach_of(const Robot& robot, int far, const Shape& shape, int near) {
  BoundingBall ball = ball_of(shape);
  JointVector reach = JointVector::Zero(robot.joint_count());
  for (int j = far; j > near; --j) {
    const Joint& joint = joint_at(robot, j);
    reach[j] = joint.type == JointType::prismatic ? 1.0 : reach_from_axis(joint, ball);
    ball = swept(joint, ball, 1);
    ball.center = joint.origin * ball.center;
  }
  return reach;
}

}  // namespace wristwise
