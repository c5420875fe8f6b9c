#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "wristwise/joints.hpp"
#include "wristwise/pose.hpp"

namespace wristwise::test {

// Brandstoetter, Angerer, Hofbaur: "An analytical solution of the inverse kinematics problem of
// industrial serial manipulators with an ortho-parallel basis and a spherical wrist" (2014), with
// the KUKA's parameters of its data sheet; flange pose in, eight solutions out.
inline std::vector<JointVector> ortho_parallel(const Pose& flange) {
  const double pi = std::acos(-1.0);
  const double a1 = 0.18, a2 = -0.12, b = 0, c1 = 0.4, c2 = 0.6, c3 = 0.62, c4 = 0.115;
  const std::array<double, 6> offsets = {0, -pi / 2, 0, 0, 0, 0};
  const std::array<double, 6> signs = {-1, 1, 1, -1, 1, -1};
  const Eigen::Matrix3d e = flange.linear();
  const Eigen::Vector3d c = flange.translation() - c4 * e.col(2);
  const double nx1 = std::sqrt(c.x() * c.x() + c.y() * c.y() - b * b) - a1;
  const double forward = std::atan2(c.y(), c.x());
  const double side = std::atan2(b, nx1 + a1);
  const double s1_sq = nx1 * nx1 + (c.z() - c1) * (c.z() - c1);
  const double s2_sq = (nx1 + 2 * a1) * (nx1 + 2 * a1) + (c.z() - c1) * (c.z() - c1);
  const double k_sq = a2 * a2 + c3 * c3;
  const auto arm2 = [&](double s_sq) {
    return std::acos((s_sq + c2 * c2 - k_sq) / (2 * std::sqrt(s_sq) * c2));
  };
  const auto arm3 = [&](double s_sq) {
    return std::acos((s_sq - c2 * c2 - k_sq) / (2 * c2 * std::sqrt(k_sq)));
  };
  const double up = std::atan2(nx1, c.z() - c1);
  const double back = std::atan2(nx1 + 2 * a1, c.z() - c1);
  const double bend = std::atan2(a2, c3);
  const std::array<std::array<double, 3>, 4> arms = {
      {{forward - side, -arm2(s1_sq) + up, arm3(s1_sq) - bend},
       {forward - side, arm2(s1_sq) + up, -arm3(s1_sq) - bend},
       {forward + side - pi, -arm2(s2_sq) - back, arm3(s2_sq) - bend},
       {forward + side - pi, arm2(s2_sq) - back, -arm3(s2_sq) - bend}}};
  std::vector<JointVector> solutions;
  for (const auto& t : arms) {
    const double s1 = std::sin(t[0]), k1 = std::cos(t[0]);
    const double s23 = std::sin(t[1] + t[2]), k23 = std::cos(t[1] + t[2]);
    const double m = e(0, 2) * s23 * k1 + e(1, 2) * s23 * s1 + e(2, 2) * k23;
    const double t4 = std::atan2(e(1, 2) * k1 - e(0, 2) * s1,
                                 e(0, 2) * k23 * k1 + e(1, 2) * k23 * s1 - e(2, 2) * s23);
    const double t5 = std::atan2(std::sqrt(1 - m * m), m);
    const double t6 = std::atan2(e(0, 1) * s23 * k1 + e(1, 1) * s23 * s1 + e(2, 1) * k23,
                                 -e(0, 0) * s23 * k1 - e(1, 0) * s23 * s1 - e(2, 0) * k23);
    for (const double flip : {0.0, 1.0}) {
      JointVector q(6);
      q << t[0], t[1], t[2], t4 + flip * pi, flip == 0 ? t5 : -t5, t6 - flip * pi;
      if (!q.allFinite()) continue;
      for (int j = 0; j < 6; ++j) {
        const auto i = static_cast<std::size_t>(j);
        q[j] = (q[j] + offsets[i]) * signs[i];
      }
      solutions.push_back(q);
    }
  }
  return solutions;
}

}  // namespace wristwise::test
