#include "kinematics/crossed_shoulder.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "kinematics/pose_polish.hpp"
#include "kinematics/turns_onto.hpp"

namespace wristwise {

// (F78) Notation of (F7): T = E1 E2 E3 E4 E5 E6 M, c the wrist centre and s the shoulder, where
// axes 1 and 2 meet, at joint zero. E1 E2 leave s in place and E4 E5 E6 leave c in place:
//   w - s = R1 R2 (E3 c - s),   w = T M^-1 c.
// Elbow. With l2 and l3 the distances of s and c from axis 3, d the distance between them along it,
// and g the angle about axis 3 from s to E3 c:
//   |w - s|^2 = d^2 + l2^2 + l3^2 - 2 l2 l3 cos g,   q3 = q3_0 +- g.
// Shoulder: two turns that take E3 c - s onto w - s. Wrist: W = (R1 R2 R3)^T R_T R_M^T is left for
// the turns 4, 5 and 6; two turns take h6 onto W h6, and q6 is what then remains.

namespace {

/// Descriptions with rounded numbers (1.5708 for pi / 2) miss the form by less; m or rad.
constexpr double kRounded = 1e-5;
/// How far outside its workspace the closed form still gives a start to polish; a share.
constexpr double kSlack = 1e-4;
/// Axes closer to parallel (rad), and lengths shorter (m) than this do not make a usable arm.
constexpr double kDegenerate = 1e-3;

Eigen::Vector3d rejected(const Eigen::Vector3d& v, const Eigen::Vector3d& axis) {
  return v - axis * axis.dot(v);
}

Eigen::Matrix3d turn(const Eigen::Vector3d& axis, double angle) {
  return Eigen::AngleAxisd(angle, axis).toRotationMatrix();
}

}  // namespace

std::shared_ptr<const CrossedShoulder> CrossedShoulder::find(
    const std::shared_ptr<const Robot>& robot) {
  if (!reason_for_no_six_axes(*robot).empty()) return nullptr;
  const SixAxes axes = axes_at_zero(*robot);
  const auto& h = axes.directions;
  for (const std::size_t j : {0U, 3U, 4U})
    if (line_angle(h[j], h[j + 1]) < kDegenerate) return nullptr;
  const Meeting shoulder = meeting_of(axes, 0, 1), wrist = meeting_of(axes, 3, 5);
  if (!(std::max(shoulder.distance, wrist.distance) <= kRounded)) return nullptr;
  std::shared_ptr<const CrossedShoulder> arm(
      new CrossedShoulder(robot, axes, shoulder.point, wrist.point));
  if (std::min(arm->upper_arm_, arm->forearm_) < kDegenerate) return nullptr;
  return arm;
}

CrossedShoulder::CrossedShoulder(std::shared_ptr<const Robot> robot, const SixAxes& axes,
                                 const Eigen::Vector3d& shoulder, const Eigen::Vector3d& wrist)
    : robot_(std::move(robot)),
      directions_(axes.directions),
      point_3_(axes.points[2]),
      shoulder_(shoulder),
      wrist_(wrist),
      side_6_(axes.directions[5].unitOrthogonal()),
      tcp_inverse_(axes.tcp.inverse()) {
  const Eigen::Vector3d& h3 = directions_[2];
  const Eigen::Vector3d to_shoulder = rejected(shoulder_ - point_3_, h3);
  const Eigen::Vector3d to_wrist = rejected(wrist_ - point_3_, h3);
  upper_arm_ = to_shoulder.norm();
  forearm_ = to_wrist.norm();
  along_ = h3.dot(wrist_ - shoulder_);
  elbow_zero_ = turn_onto(h3, to_wrist, to_shoulder);
}

void CrossedShoulder::solve(const Pose& tcp, std::vector<JointVector>& branches) const {
  branches.clear();
  const Pose moved = tcp * tcp_inverse_;
  const double distance2 = (moved * wrist_ - shoulder_).squaredNorm();
  const double cosine =
      (along_ * along_ + upper_arm_ * upper_arm_ + forearm_ * forearm_ - distance2) /
      (2 * upper_arm_ * forearm_);
  if (!(std::abs(cosine) <= 1 + kSlack)) return;
  const double angle = std::acos(std::clamp(cosine, -1.0, 1.0));
  solve_shoulder(moved, elbow_zero_ + angle, tcp, branches);
  if (std::abs(cosine) < 1) solve_shoulder(moved, elbow_zero_ - angle, tcp, branches);
}

void CrossedShoulder::solve_shoulder(const Pose& moved, double elbow, const Pose& tcp,
                                     std::vector<JointVector>& branches) const {
  const auto& h = directions_;
  const Eigen::Matrix3d turn_3 = turn(h[2], elbow);
  const Eigen::Vector3d from = point_3_ + turn_3 * (wrist_ - point_3_) - shoulder_;
  const Eigen::Vector3d to = moved * wrist_ - shoulder_;
  for (const TwoTurns& arm : two_turns_onto(h[0], h[1], from, to, kSlack)) {
    const Eigen::Matrix3d turned = turn(h[0], arm.first) * turn(h[1], arm.second) * turn_3;
    JointVector q(6);
    q << arm.first, arm.second, elbow, 0, 0, 0;
    solve_wrist(turned.transpose() * moved.linear(), q, tcp, branches);
  }
}

void CrossedShoulder::solve_wrist(const Eigen::Matrix3d& left, JointVector q, const Pose& tcp,
                                  std::vector<JointVector>& branches) const {
  const auto& h = directions_;
  for (const TwoTurns& wrist : two_turns_onto(h[3], h[4], h[5], left * h[5], kSlack)) {
    const Eigen::Matrix3d turned = turn(h[3], wrist.first) * turn(h[4], wrist.second);
    const double last = turn_onto(h[5], side_6_, turned.transpose() * left * side_6_);
    q.tail<3>() << wrist.first, wrist.second, last;
    append_polished(*robot_, tcp, q, 0, branches);
  }
}

std::string CrossedShoulder::description() const {
  char text[256];
  std::snprintf(
      text, sizeof text,
      "axes 1 and 2 meet, spherical wrist, closed form: upper arm %.4g m, forearm %.4g m, "
      "wrist centre to TCP %.4g m",
      upper_arm_, forearm_, (tcp_inverse_ * wrist_).norm());
  return text;
}

}  // namespace wristwise
