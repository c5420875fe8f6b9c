#include "kinematics/elbow.hpp"

#include <algorithm>
#include <cmath>

namespace wristwise {

namespace {

Eigen::Vector3d rejected(const Eigen::Vector3d& v, const Eigen::Vector3d& axis) {
  return v - axis * axis.dot(v);
}

}  // namespace

Elbow::Elbow(const Eigen::Vector3d& point, const Eigen::Vector3d& direction,
             const Eigen::Vector3d& shoulder, const Eigen::Vector3d& wrist) {
  const Eigen::Vector3d to_shoulder = rejected(shoulder - point, direction);
  const Eigen::Vector3d to_wrist = rejected(wrist - point, direction);
  upper_arm_ = to_shoulder.norm();
  forearm_ = to_wrist.norm();
  along_ = direction.dot(wrist - shoulder);
  zero_ = turn_onto(direction, to_wrist, to_shoulder);
}

UpToTwo<double> Elbow::angles(double squared_distance, double slack) const {
  UpToTwo<double> angles;
  const double cosine =
      (along_ * along_ + upper_arm_ * upper_arm_ + forearm_ * forearm_ - squared_distance) /
      (2 * upper_arm_ * forearm_);
  if (!(std::abs(cosine) <= 1 + slack)) return angles;
  const double angle = std::acos(std::clamp(cosine, -1.0, 1.0));
  angles.add(zero_ + angle);
  if (std::abs(cosine) < 1) angles.add(zero_ - angle);
  return angles;
}

}  // namespace wristwise
