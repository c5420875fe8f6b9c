#include "kinematics/crossed_shoulder.hpp"

#include <algorithm>
#include <cstdio>
#include <utility>

#include "kinematics/pose_polish.hpp"
#include "kinematics/turns_onto.hpp"

namespace wristwise {

// (F78) Notation of (F7): T = E1 E2 E3 E4 E5 E6 M, c the wrist centre and s the shoulder, where
// axes 1 and 2 meet, at joint zero. E1 E2 leave s in place and E4 E5 E6 leave c in place:
//   w - s = R1 R2 (E3 c - s),   w = T M^-1 c.
// Elbow: its angle sets |w - s|. Shoulder: two turns that take E3 c - s onto w - s. Wrist:
// W = (R1 R2 R3)^T R_T R_M^T is left for the turns 4, 5 and 6; two turns take h6 onto W h6, and q6
// is what then remains.

std::shared_ptr<const CrossedShoulder> CrossedShoulder::find(
    const std::shared_ptr<const Robot>& robot) {
  if (!reason_for_no_six_axes(*robot).empty()) return nullptr;
  const SixAxes axes = axes_at_zero(*robot);
  const auto& h = axes.directions;
  for (const std::size_t j : {0U, 3U, 4U})
    if (line_angle(h[j], h[j + 1]) < kDegenerateAxes) return nullptr;
  const Meeting shoulder = meeting_of(axes, 0, 1), wrist = meeting_of(axes, 3, 5);
  if (!(std::max(shoulder.distance, wrist.distance) <= kRoundedNumbers)) return nullptr;
  std::shared_ptr<const CrossedShoulder> arm(
      new CrossedShoulder(robot, axes, shoulder.point, wrist.point));
  if (std::min(arm->elbow_.upper_arm(), arm->elbow_.forearm()) < kDegenerateAxes) return nullptr;
  return arm;
}

CrossedShoulder::CrossedShoulder(std::shared_ptr<const Robot> robot, const SixAxes& axes,
                                 const Eigen::Vector3d& shoulder, const Eigen::Vector3d& wrist)
    : robot_(std::move(robot)),
      axes_(axes),
      shoulder_(shoulder),
      wrist_(wrist),
      side_6_(axes.directions[5].unitOrthogonal()),
      tcp_inverse_(axes.tcp.inverse()),
      elbow_(axes.points[2], axes.directions[2], shoulder, wrist) {}

void CrossedShoulder::solve(const Pose& tcp, std::vector<JointVector>& branches) const {
  branches.clear();
  const auto& h = axes_.directions;
  const Pose moved = tcp * tcp_inverse_;
  const Eigen::Vector3d to = moved * wrist_ - shoulder_;
  for (const double elbow : elbow_.angles(to.squaredNorm(), kSlackOfStarts)) {
    const Pose turn_3 = turn_about(axes_, 2, elbow);
    const Eigen::Vector3d from = turn_3 * wrist_ - shoulder_;
    for (const TwoTurns& arm : two_turns_onto(h[0], h[1], from, to, kSlackOfStarts)) {
      const Eigen::Matrix3d turned = Eigen::AngleAxisd(arm.first, h[0]) *
                                     Eigen::AngleAxisd(arm.second, h[1]) * turn_3.linear();
      JointVector q(6);
      q << arm.first, arm.second, elbow, 0, 0, 0;
      solve_wrist(turned.transpose() * moved.linear(), q, tcp, branches);
    }
  }
}

void CrossedShoulder::solve_wrist(const Eigen::Matrix3d& left, JointVector q, const Pose& tcp,
                                  std::vector<JointVector>& branches) const {
  const auto& h = axes_.directions;
  for (const TwoTurns& wrist : two_turns_onto(h[3], h[4], h[5], left * h[5], kSlackOfStarts)) {
    const Eigen::Quaterniond turned =
        Eigen::AngleAxisd(wrist.first, h[3]) * Eigen::AngleAxisd(wrist.second, h[4]);
    const double last = turn_onto(h[5], side_6_, turned.conjugate() * (left * side_6_));
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
      elbow_.upper_arm(), elbow_.forearm(), (tcp_inverse_ * wrist_).norm());
  return text;
}

}  // namespace wristwise
