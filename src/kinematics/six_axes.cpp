#include "kinematics/six_axes.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "wristwise/kinematics.hpp"

namespace wristwise {
namespace {

/// The projection along an axis: I - h h^T takes a vector to its part perpendicular to the axis.
Eigen::Matrix3d rejection(const Eigen::Vector3d& axis) {
  return Eigen::Matrix3d::Identity() - axis * axis.transpose();
}

}  // namespace

std::string reason_for_no_six_axes(const Robot& robot) {
  if (robot.joint_count() != 6)
    return "the chain has " + std::to_string(robot.joint_count()) + " movable joints, not six";
  for (const Joint& joint : robot.joints())
    if (joint.type == JointType::prismatic) return "joint '" + joint.name + "' is prismatic";
  return {};
}

SixAxes axes_at_zero(const Robot& robot) {
  ChainPose chain;
  forward_kinematics(robot, JointVector::Zero(robot.joint_count()), chain);
  SixAxes axes;
  for (std::size_t j = 0; j < 6; ++j) {
    axes.points[j] = chain.frames[j].translation();
    axes.directions[j] = chain.axes[j];
  }
  axes.tcp = chain.tcp;
  return axes;
}

Pose turn_about(const SixAxes& axes, std::size_t j, double angle) {
  return Eigen::Translation3d(axes.points[j]) * Eigen::AngleAxisd(angle, axes.directions[j]) *
         Eigen::Translation3d(-axes.points[j]);
}

double line_angle(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), std::abs(a.dot(b)));
}

/// Least squares: the point with the least sum of squared distances from the axes.
Meeting meeting_of(const SixAxes& axes, std::size_t first, std::size_t last) {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  const Eigen::Vector3d origin = axes.points[last];  // nearby: little is lost to cancellation
  for (std::size_t j = first; j <= last; ++j) {
    const Eigen::Matrix3d part = rejection(axes.directions[j]);
    normal += part;
    right += part * (axes.points[j] - origin);
  }
  Meeting meeting{origin + normal.ldlt().solve(right)};
  for (std::size_t j = first; j <= last; ++j) {
    const Eigen::Vector3d apart = rejection(axes.directions[j]) * (meeting.point - axes.points[j]);
    meeting.distance = std::max(meeting.distance, apart.norm());
  }
  return meeting;
}

}  // namespace wristwise
