#include "wristwise/tolerance.hpp"

#include <cmath>

#include "wristwise/error.hpp"

namespace wristwise {

namespace {

constexpr double kRightAngle = 1.57079632679489661923;

/// The frame in whose axes positions are measured.
Eigen::Matrix3d position_axes(const ToleranceBox& box, const Pose& path_frame) {
  return box.frame == ToleranceFrame::path ? path_frame.linear().eval()
                                           : Eigen::Matrix3d::Identity().eval();
}

}  // namespace

bool ToleranceBox::is_free(int coordinate) const {
  return std::isinf(lower[coordinate]) && std::isinf(upper[coordinate]);
}

EulerSequence ToleranceBox::sequence() const {
  const bool x = is_free(3), y = is_free(4), z = is_free(5);
  if (x && !z) return EulerSequence::yzx;
  if (y && !x) return EulerSequence::zxy;
  return EulerSequence::xyz;
}

void ToleranceBox::validate(const std::string& where) const {
  for (int k = 0; k < 6; ++k) {
    const std::string name = where + "." + kCoordinateNames[static_cast<std::size_t>(k)];
    if (std::isnan(lower[k]) || std::isnan(upper[k])) {
      throw InvalidInput(name, "bound is not a number", "finite bounds or free");
    }
    if (lower[k] > upper[k]) {
      throw InvalidInput(name, "lower bound is above the upper bound", "[lower, upper]");
    }
    if (k < 3 && (std::isinf(lower[k]) || std::isinf(upper[k]))) {
      throw InvalidInput(name, "a position can't be free", "finite bounds in m");
    }
    if (std::isinf(lower[k]) != std::isinf(upper[k])) {
      throw InvalidInput(name, "bounded on one side only", "two finite bounds or free");
    }
  }
  const int middle = 3 + euler_axes(sequence())[1];
  if (!is_free(middle) && (lower[middle] <= -kRightAngle || upper[middle] >= kRightAngle)) {
    throw InvalidInput(where + "." + kCoordinateNames[static_cast<std::size_t>(middle)],
                       "reaches 90 deg, where the angles about the other two axes coincide",
                       "bounds inside (-90 deg, 90 deg), or make this the free axis");
  }
}

ToleranceBox ToleranceBox::widened(double position, double angle) const {
  ToleranceBox wider = *this;
  wider.lower.head<3>().array() -= position;
  wider.upper.head<3>().array() += position;
  wider.lower.tail<3>().array() -= angle;
  wider.upper.tail<3>().array() += angle;
  return wider;
}

// (F3) path frame: e = (R_p^T (p_ee - p_p), angles(R_p^T R_ee));
//      base frame: e = (p_ee - p_p, wrap(angles(R_ee) - angles(R_p))).
Vector6 deviation(const ToleranceBox& box, const Pose& path_frame, const Pose& tcp) {
  const EulerSequence sequence = box.sequence();
  Vector6 e;
  e.head<3>() =
      position_axes(box, path_frame).transpose() * (tcp.translation() - path_frame.translation());
  if (box.frame == ToleranceFrame::path) {
    e.tail<3>() = euler_angles(path_frame.linear().transpose() * tcp.linear(), sequence);
  } else {
    e.tail<3>() =
        euler_angles(tcp.linear(), sequence) - euler_angles(path_frame.linear(), sequence);
    for (int k = 3; k < 6; ++k) e[k] = wrap_angle(e[k]);
  }
  return e;
}

Pose pose_at_deviation(const ToleranceBox& box, const Pose& path_frame, const Vector6& e) {
  const EulerSequence sequence = box.sequence();
  Pose pose = Pose::Identity();
  pose.translation() = path_frame.translation() + position_axes(box, path_frame) * e.head<3>();
  if (box.frame == ToleranceFrame::path) {
    pose.linear() = path_frame.linear() * rotation_from_euler(e.tail<3>(), sequence);
  } else {
    pose.linear() =
        rotation_from_euler(euler_angles(path_frame.linear(), sequence) + e.tail<3>(), sequence);
  }
  return pose;
}

// (F4) Rows 0-2: R_p^T J_v (path) or J_v (base). Rows 3-5: rate matrix (F2) at the angles of
// R_p^T R_ee times R_p^T J_omega (path), or at the angles of R_ee times J_omega (base).
Jacobian deviation_jacobian(const ToleranceBox& box, const Pose& path_frame, const Pose& tcp,
                            const Jacobian& geometric) {
  const EulerSequence sequence = box.sequence();
  const Eigen::Matrix3d to_axes = position_axes(box, path_frame).transpose();
  const Eigen::Vector3d angles = euler_angles(to_axes * tcp.linear(), sequence);
  const Eigen::Matrix3d rates = euler_rate_matrix(angles, sequence) * to_axes;
  Jacobian result(6, geometric.cols());
  result.topRows<3>().noalias() = to_axes * geometric.topRows<3>();
  result.bottomRows<3>().noalias() = rates * geometric.bottomRows<3>();
  return result;
}

Vector6 box_excess(const ToleranceBox& box, const Vector6& e) {
  return (box.lower - e).cwiseMax(e - box.upper).cwiseMax(0.0);
}

}  // namespace wristwise
