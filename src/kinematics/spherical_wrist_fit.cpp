#include "kinematics/spherical_wrist_fit.hpp"

#include <cstdio>
#include <utility>

namespace wristwise {
namespace {

/// Axes closer to parallel (rad), and lengths shorter (m) than this do not make a usable arm.
constexpr double kDegenerate = 1e-3;

std::string with_number(const char* format, double value) {
  char text[160];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

double degrees(double angle) { return angle * 57.29577951308232; }

/// The projection along an axis: I - h h^T takes a vector to its part perpendicular to the axis.
Eigen::Matrix3d rejection(const Eigen::Vector3d& axis) {
  return Eigen::Matrix3d::Identity() - axis * axis.transpose();
}

std::string failed_directions(const SixAxes& axes, double misfit) {
  const auto& h = axes.directions;
  if (line_angle(h[1], h[2]) > misfit) {
    return with_number("axes 2 and 3 are %.4g deg from parallel", degrees(line_angle(h[1], h[2])));
  }
  const auto parallel = [&h](std::size_t a, std::size_t b) -> std::string {
    const double angle = line_angle(h[a], h[b]);
    if (angle >= kDegenerate) return {};
    return "axes " + std::to_string(a + 1) + " and " + std::to_string(b + 1) +
           with_number(" are parallel to %.2g deg", degrees(angle));
  };
  for (const auto& [a, b] : {std::pair{0, 1}, std::pair{3, 4}, std::pair{4, 5}}) {
    std::string failure = parallel(static_cast<std::size_t>(a), static_cast<std::size_t>(b));
    if (!failure.empty()) return failure;
  }
  return {};
}

std::string failed_lengths(const SixAxes& axes, const Eigen::Vector3d& wrist,
                           double position_misfit, double misfit) {
  if (!(position_misfit <= misfit)) {
    return with_number("axes 4, 5 and 6 do not meet: they pass their nearest point at %.4g mm",
                       1e3 * position_misfit);
  }
  const Eigen::Matrix3d part = rejection(axes.directions[1]);
  const double upper_arm = (part * (axes.points[2] - axes.points[1])).norm();
  const double forearm = (part * (wrist - axes.points[2])).norm();
  if (upper_arm < kDegenerate) {
    return with_number("axes 2 and 3 are only %.2g mm apart", 1e3 * upper_arm);
  }
  if (forearm < kDegenerate) {
    return with_number("the wrist centre is only %.2g mm from axis 3", 1e3 * forearm);
  }
  return {};
}

/// Makes axes 2 and 3 exactly parallel by turning both half the way.
void make_parallel(Eigen::Vector3d& a, Eigen::Vector3d& b) {
  const double sign = a.dot(b) < 0 ? -1 : 1;
  a = (a + sign * b).normalized();
  b = sign * a;
}

}  // namespace

SphericalWristFit fit_spherical_wrist(const Robot& robot, double misfit) {
  SphericalWristFit fit;
  fit.failure = reason_for_no_six_axes(robot);
  if (!fit.failure.empty()) return fit;
  SixAxes axes = axes_at_zero(robot);
  fit.failure = failed_directions(axes, misfit);
  if (!fit.failure.empty()) return fit;
  const Meeting wrist = meeting_of(axes, 3, 5);
  fit.position_misfit = wrist.distance;
  fit.angle_misfit = line_angle(axes.directions[1], axes.directions[2]);
  fit.failure = failed_lengths(axes, wrist.point, fit.position_misfit, misfit);
  if (!fit.failure.empty()) return fit;
  make_parallel(axes.directions[1], axes.directions[2]);
  fit.arm.emplace(axes, wrist.point);
  return fit;
}

}  // namespace wristwise
