#include "kinematics/three_parallel_axes.hpp"

#include <algorithm>
#include <cstdio>
#include <utility>

#include "kinematics/pose_polish.hpp"
#include "kinematics/turns_onto.hpp"

namespace wristwise {

// (F79) Notation of (F7): G = T M^-1 = E1 E2 E3 E4 E5 E6, h the direction of axis 2 and s3, s4 the
// signs of axes 3 and 4 along it, c where axes 5 and 6 meet. E2 E3 E4 turns by
// theta = q2 + s3 q3 + s4 q4 about h and leaves components along h as they are.
// Shoulder. E5 E6 leave c in place: the vector E1^-1 G c - p1 has the component of c - p1 along h
// and that of G c - p1 along h1.
// Wrist. With Q = E1^-1 G: two turns, theta about h and q5 about h5, take h6 onto R_Q h6; q6 is
// what then remains of R_Q. Plane. P = Q (E5 E6)^-1 = E2 E3 E4, and E4 leaves p4 in place: q3 sets
// the distance of P p4 from p2, q2 turns E3 p4 - p2 onto P p4 - p2, and q4 makes up theta.

std::shared_ptr<const ThreeParallelAxes> ThreeParallelAxes::find(
    const std::shared_ptr<const Robot>& robot) {
  if (!reason_for_no_six_axes(*robot).empty()) return nullptr;
  const SixAxes axes = axes_at_zero(*robot);
  const auto& h = axes.directions;
  if (std::max(line_angle(h[1], h[2]), line_angle(h[1], h[3])) > kRoundedNumbers) return nullptr;
  for (const std::size_t j : {0U, 3U, 4U})
    if (line_angle(h[j], h[j + 1]) < kDegenerateAxes) return nullptr;
  const Meeting wrist = meeting_of(axes, 4, 5);
  if (!(wrist.distance <= kRoundedNumbers)) return nullptr;
  std::shared_ptr<const ThreeParallelAxes> arm(new ThreeParallelAxes(robot, axes, wrist.point));
  if (std::min(arm->elbow_.upper_arm(), arm->elbow_.forearm()) < kDegenerateAxes) return nullptr;
  return arm;
}

ThreeParallelAxes::ThreeParallelAxes(std::shared_ptr<const Robot> robot, const SixAxes& axes,
                                     const Eigen::Vector3d& wrist)
    : robot_(std::move(robot)),
      axes_(axes),
      wrist_(wrist),
      side_6_(axes.directions[5].unitOrthogonal()),
      tcp_inverse_(axes.tcp.inverse()),
      elbow_(axes.points[2], axes.directions[2], axes.points[1], axes.points[3]) {
  const auto& h = axes.directions;
  sign_3_ = h[1].dot(h[2]) < 0 ? -1 : 1;
  sign_4_ = h[1].dot(h[3]) < 0 ? -1 : 1;
}

void ThreeParallelAxes::solve(const Pose& tcp, std::vector<JointVector>& branches) const {
  branches.clear();
  const Eigen::Vector3d &h1 = axes_.directions[0], &h = axes_.directions[1], &p1 = axes_.points[0];
  const Pose moved = tcp * tcp_inverse_;
  const Eigen::Vector3d to = moved * wrist_ - p1;
  for (const Eigen::Vector3d& from :
       vectors_with({h1, h1.dot(to)}, {h, h.dot(wrist_ - p1)}, to.squaredNorm(), kSlackOfStarts)) {
    const double shoulder = turn_onto(h1, from, to);
    solve_wrist(turn_about(axes_, 0, -shoulder) * moved, shoulder, tcp, branches);
  }
}

void ThreeParallelAxes::solve_wrist(const Pose& left, double shoulder, const Pose& tcp,
                                    std::vector<JointVector>& branches) const {
  const auto& h = axes_.directions;
  for (const TwoTurns& turns :
       two_turns_onto(h[1], h[4], h[5], left.linear() * h[5], kSlackOfStarts)) {
    const Eigen::Quaterniond turned =
        Eigen::AngleAxisd(turns.first, h[1]) * Eigen::AngleAxisd(turns.second, h[4]);
    const double last = turn_onto(h[5], side_6_, turned.conjugate() * (left.linear() * side_6_));
    const Pose plane = left * turn_about(axes_, 5, -last) * turn_about(axes_, 4, -turns.second);
    JointVector q(6);
    q << shoulder, 0, 0, 0, turns.second, last;
    solve_plane(plane, turns.first, q, tcp, branches);
  }
}

void ThreeParallelAxes::solve_plane(const Pose& left, double turned, JointVector q, const Pose& tcp,
                                    std::vector<JointVector>& branches) const {
  const Eigen::Vector3d &p2 = axes_.points[1], &p4 = axes_.points[3];
  const Eigen::Vector3d to = left * p4 - p2;
  for (const double elbow : elbow_.angles(to.squaredNorm(), kSlackOfStarts)) {
    const Eigen::Vector3d from = turn_about(axes_, 2, elbow) * p4 - p2;
    q[1] = turn_onto(axes_.directions[1], from, to);
    q[2] = elbow;
    q[3] = sign_4_ * (turned - q[1] - sign_3_ * elbow);
    append_polished(*robot_, tcp, q, 0, branches);
  }
}

std::string ThreeParallelAxes::description() const {
  char text[256];
  std::snprintf(
      text, sizeof text,
      "axes 2, 3 and 4 parallel, closed form: upper arm %.4g m, forearm %.4g m, from where "
      "axes 5 and 6 meet to TCP %.4g m",
      elbow_.upper_arm(), elbow_.forearm(), (tcp_inverse_ * wrist_).norm());
  return text;
}

}  // namespace wristwise
