#pragma once

// The closed form of arms of the UR type, from the published equations: K. Hawkins, "Analytic
// inverse kinematics for the Universal Robots UR-5/UR-10 arms", Georgia Tech 2013. Shares nothing
// with the library.

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <vector>

namespace wristwise::test {

struct UrDimensions {
  double d1, a2, a3, d4, d5, d6;  // m; a2 and a3 negative
};

class UrClosedForm {
 public:
  using Angles = std::array<double, 6>;

  explicit UrClosedForm(const UrDimensions& size) : size_(size) {}

  /// Up to eight; fewer where a pair coincides or is out of reach.
  std::vector<Angles> solve(const Eigen::Isometry3d& flange) const {
    std::vector<Angles> solutions;
    const Eigen::Vector3d wrist = flange.translation() - size_.d6 * flange.linear().col(2);
    const double radius = std::hypot(wrist.x(), wrist.y());
    if (radius < size_.d4) return solutions;
    const double towards = std::atan2(wrist.y(), wrist.x());
    for (const double side : {1.0, -1.0}) {
      const double q1 = towards + side * std::acos(size_.d4 / radius) + kPi / 2;
      solve_wrist(flange, q1, solutions);
    }
    return solutions;
  }

  Eigen::Isometry3d forward(const Angles& q) const {
    return link(q[0], size_.d1, 0, kPi / 2) * link(q[1], 0, size_.a2, 0) *
           link(q[2], 0, size_.a3, 0) * link(q[3], size_.d4, 0, kPi / 2) *
           link(q[4], size_.d5, 0, -kPi / 2) * link(q[5], size_.d6, 0, 0);
  }

 private:
  static constexpr double kPi = 3.14159265358979323846;

  static Eigen::Isometry3d link(double q, double d, double a, double alpha) {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    const double c = std::cos(q), s = std::sin(q), ca = std::cos(alpha), sa = std::sin(alpha);
    pose.matrix() << c, -s * ca, s * sa, a * c, s, c * ca, -c * sa, a * s, 0, sa, ca, d, 0, 0, 0, 1;
    return pose;
  }

  void solve_wrist(const Eigen::Isometry3d& flange, double q1,
                   std::vector<Angles>& solutions) const {
    const double s1 = std::sin(q1), c1 = std::cos(q1);
    const double cosine =
        (flange.translation().x() * s1 - flange.translation().y() * c1 - size_.d4) / size_.d6;
    if (std::abs(cosine) > 1) return;
    const Eigen::Matrix3d r = flange.linear();
    for (const double flip : {1.0, -1.0}) {
      const double q5 = flip * std::acos(cosine), s5 = std::sin(q5);
      const double q6 =
          std::atan2((-r(0, 1) * s1 + r(1, 1) * c1) / s5, (r(0, 0) * s1 - r(1, 0) * c1) / s5);
      solve_arm(flange, {q1, 0, 0, 0, q5, q6}, solutions);
    }
  }

  void solve_arm(const Eigen::Isometry3d& flange, Angles q, std::vector<Angles>& solutions) const {
    const Eigen::Isometry3d rest = link(q[0], size_.d1, 0, kPi / 2).inverse() * flange *
                                   link(q[5], size_.d6, 0, 0).inverse() *
                                   link(q[4], size_.d5, 0, -kPi / 2).inverse();
    const Eigen::Vector3d p = rest * Eigen::Vector3d(0, -size_.d4, 0);
    const double length = std::hypot(p.x(), p.y());
    const double cosine =
        (length * length - size_.a2 * size_.a2 - size_.a3 * size_.a3) / (2 * size_.a2 * size_.a3);
    if (std::abs(cosine) > 1) return;
    for (const double elbow : {1.0, -1.0}) {
      q[2] = elbow * std::acos(cosine);
      q[1] = std::atan2(p.y(), p.x()) -
             std::atan2(size_.a3 * std::sin(q[2]), size_.a2 + size_.a3 * std::cos(q[2]));
      const Eigen::Isometry3d last =
          (link(q[1], 0, size_.a2, 0) * link(q[2], 0, size_.a3, 0)).inverse() * rest;
      q[3] = std::atan2(last.linear()(1, 0), last.linear()(0, 0));
      if ((forward(q).matrix() - flange.matrix()).norm() < 1e-7) solutions.push_back(q);
    }
  }

  UrDimensions size_;
};

inline UrClosedForm ur5e_closed_form() {
  return UrClosedForm({0.1625, -0.425, -0.3922, 0.1333, 0.0997, 0.0996});
}

inline UrClosedForm ur10e_closed_form() {
  return UrClosedForm({0.1807, -0.6127, -0.57155, 0.17415, 0.11985, 0.11655});
}

}  // namespace wristwise::test
