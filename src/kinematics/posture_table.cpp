#include "kinematics/posture_table.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "wristwise/kinematics.hpp"

namespace wristwise {
namespace {

constexpr double kPerJoint = 64;  // postures along each inner joint, where there are few
constexpr double kOnAxis = 1e-9;  // m
constexpr int kProbes = 512;
constexpr double kGapMargin = 2;
constexpr double kShortest = 1e-3;  // m

Pose axis_frame(const Joint& joint) {
  Pose frame = Pose::Identity();
  const Eigen::Vector3d z = joint.origin.linear() * joint.axis;
  frame.linear() =
      Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), z).toRotationMatrix();
  frame.translation() = joint.origin.translation();
  return frame;
}

}  // namespace

PostureTable::PostureTable(std::shared_ptr<const Robot> robot, JointVector lower, JointVector upper,
                           int count)
    : robot_(std::move(robot)),
      lower_(std::move(lower)),
      upper_(std::move(upper)),
      shoulder_(axis_frame(robot_->joints().front())),
      even_(inner_joints()) {
  const double enough = std::pow(kPerJoint, inner_joints());
  const int size = static_cast<int>(std::min<double>(count, std::max(1.0, enough)));
  length_ = std::max(longest_reach(std::max(size, kProbes)) / 2, kShortest);
  std::vector<NearestKeys::Key> keys;
  for (int i = 0; i < size; ++i) {
    JointVector q = sample(i);
    const Seen seen = see(tcp_pose(*robot_, q));
    if (first_is_free()) q[0] -= seen.first;
    postures_.push_back(std::move(q));
    keys.push_back(seen.key);
  }
  keys_ = std::make_unique<const NearestKeys>(std::move(keys));
  within_reach_ = kGapMargin * widest_gap(size, kProbes) + kOnAxis;
}

int PostureTable::inner_joints() const {
  return std::max(0, robot_->joint_count() - (first_is_free() ? 1 : 0) - (last_is_free() ? 1 : 0));
}

/// Point of a sequence that fills the box of the joints evenly.
JointVector PostureTable::sample(int index) const {
  JointVector q = 0.5 * (lower_ + upper_);
  const int first = first_is_free() ? 1 : 0;
  for (int k = 0; k < inner_joints(); ++k) {
    const int j = first + k;
    q[j] = lower_[j] + even_.at(index, k) * (upper_[j] - lower_[j]);
  }
  return q;
}

double PostureTable::longest_reach(int samples) const {
  double reach = 0;
  for (int i = 0; i < samples; ++i) {
    const Pose tcp = tcp_pose(*robot_, sample(i));
    reach = std::max(reach, (tcp.translation() - shoulder_.translation()).norm());
  }
  return reach;
}

/// (F72) What turning the first and the last joint does not change.
PostureTable::Seen PostureTable::see(const Pose& tcp) const {
  const Joint& last_joint = robot_->joints().back();
  const Pose last = shoulder_.inverse() * tcp * robot_->tcp().inverse();
  Eigen::Matrix3d directions = Eigen::Matrix3d::Zero();
  if (last_is_free()) {
    directions.col(0) = last.linear() * last_joint.axis;
  } else {
    directions.leftCols<2>() = last.linear().leftCols<2>();
  }
  Eigen::Vector3d point = last.translation();
  Seen seen;
  if (first_is_free() && robot_->joints().front().type == JointType::prismatic) {
    seen.first = point.z();
    point.z() = 0;
  } else if (first_is_free()) {
    const bool on_axis = point.head<2>().norm() < kOnAxis;
    const Eigen::Vector3d sideways = on_axis ? Eigen::Vector3d(directions.col(0)) : point;
    seen.first = std::atan2(sideways.y(), sideways.x());
    const Eigen::Matrix3d back =
        Eigen::AngleAxisd(-seen.first, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    point = back * point;
    directions = back * directions;
  }
  seen.key << point / length_, directions.col(0), directions.col(1);
  return seen;
}

double PostureTable::widest_gap(int first_sample, int samples) const {
  double widest = 0;
  std::vector<NearestKeys::Neighbour> nearest;
  for (int i = first_sample; i < first_sample + samples; ++i) {
    keys_->find(see(tcp_pose(*robot_, sample(i))).key, 1, nearest);
    widest = std::max(widest, nearest.front().square);
  }
  return std::sqrt(widest);
}

void PostureTable::find(const Pose& tcp, int count, double slack, Found& found) const {
  const Seen seen = see(tcp);
  found.first = seen.first;
  keys_->find(seen.key, static_cast<std::size_t>(count), found.postures);
  const double nearest = std::sqrt(found.postures.front().square);
  if (!(nearest <= within_reach_ + slack)) found.postures.clear();
}

JointVector PostureTable::towards(const Pose& tcp, const Found& found, int index) const {
  JointVector q = posture(index);
  if (first_is_free()) {
    q[0] += found.first;
    if (robot_->joints().front().type != JointType::prismatic) q[0] = wrap_angle(q[0]);
  }
  if (!last_is_free()) return q;
  const auto last = q.size() - 1;
  const Pose wanted = tcp * robot_->tcp().inverse();
  q[last] = 0;
  ChainPose chain;
  forward_kinematics(*robot_, q, chain);
  const Eigen::Quaterniond turn(
      Eigen::Matrix3d(chain.frame(static_cast<int>(last)).linear().transpose() * wanted.linear()));
  q[last] = wrap_angle(2 * std::atan2(turn.vec().dot(robot_->joints().back().axis), turn.w()));
  return q;
}

}  // namespace wristwise
