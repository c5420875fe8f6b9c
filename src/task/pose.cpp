#include "wristwise/pose.hpp"

#include <cmath>

namespace wristwise {

namespace {

constexpr double kPi = 3.14159265358979323846;

double half_open(double angle) { return angle <= -kPi ? kPi : angle; }

}  // namespace

std::array<int, 3> euler_axes(EulerSequence sequence) {
  switch (sequence) {
    case EulerSequence::yzx:
      return {1, 2, 0};
    case EulerSequence::zxy:
      return {2, 0, 1};
    case EulerSequence::xyz:
      break;
  }
  return {0, 1, 2};
}

// (F1) With the axes renamed cyclically every sequence reads M = Rx(a) Ry(b) Rz(c):
//   M00 = cos b cos c, M01 = -cos b sin c, M02 = sin b,
// and M Rz(-c) = Rx(a) Ry(b) has (1,1) = cos a, (2,1) = sin a: taken from there, a fits the c that
// was chosen, also where cos b vanishes and c is arbitrary.
Eigen::Vector3d euler_angles(const Eigen::Matrix3d& rotation, EulerSequence sequence) {
  const auto axis = euler_axes(sequence);
  const auto m = [&](int row, int column) {
    return rotation(axis[static_cast<std::size_t>(row)], axis[static_cast<std::size_t>(column)]);
  };
  const double cos_b = std::hypot(m(0, 0), m(0, 1));
  const double b = std::atan2(m(0, 2), cos_b);
  const double c = cos_b < 1e-12 ? 0.0 : half_open(std::atan2(-m(0, 1), m(0, 0)));
  const double a = std::atan2(m(2, 0) * std::sin(c) + m(2, 1) * std::cos(c),
                              m(1, 0) * std::sin(c) + m(1, 1) * std::cos(c));
  Eigen::Vector3d angles;
  angles[axis[0]] = half_open(a);
  angles[axis[1]] = b;
  angles[axis[2]] = c;
  return angles;
}

Eigen::Matrix3d rotation_from_euler(const Eigen::Vector3d& angles, EulerSequence sequence) {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  for (const int axis : euler_axes(sequence)) {
    rotation *= Eigen::AngleAxisd(angles[axis], Eigen::Vector3d::Unit(axis)).toRotationMatrix();
  }
  return rotation;
}

// (F2) For M = Rx(a) Ry(b) Rz(c), omega = ex a' + Rx(a) ey b' + Rx(a) Ry(b) ez c'. Solved for the
// rates:  c' = (cos a wz - sin a wy) / cos b,  b' = cos a wy + sin a wz,  a' = wx - sin b c'.
Eigen::Matrix3d euler_rate_matrix(const Eigen::Vector3d& angles, EulerSequence sequence) {
  const auto axis = euler_axes(sequence);
  const double sin_a = std::sin(angles[axis[0]]), cos_a = std::cos(angles[axis[0]]);
  const double sin_b = std::sin(angles[axis[1]]);
  const double cos_b = std::max(std::cos(angles[axis[1]]), 1e-9);
  Eigen::Matrix3d renamed;
  renamed << 1, sin_a * sin_b / cos_b, -cos_a * sin_b / cos_b,  //
      0, cos_a, sin_a,                                          //
      0, -sin_a / cos_b, cos_a / cos_b;
  Eigen::Matrix3d rates;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      rates(axis[static_cast<std::size_t>(row)], axis[static_cast<std::size_t>(column)]) =
          renamed(row, column);
    }
  }
  return rates;
}

Pose pose_from_xyz_rpy(const Eigen::Vector3d& xyz, const Eigen::Vector3d& rpy) {
  Pose pose = Pose::Identity();
  pose.translation() = xyz;
  pose.linear() = (Eigen::AngleAxisd(rpy.z(), Eigen::Vector3d::UnitZ()) *
                   Eigen::AngleAxisd(rpy.y(), Eigen::Vector3d::UnitY()) *
                   Eigen::AngleAxisd(rpy.x(), Eigen::Vector3d::UnitX()))
                      .toRotationMatrix();
  return pose;
}

double wrap_angle(double angle) { return half_open(std::remainder(angle, 2 * kPi)); }

}  // namespace wristwise
