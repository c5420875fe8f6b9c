#pragma once

#include <array>
#include <limits>
#include <string>

#include "wristwise/joints.hpp"
#include "wristwise/pose.hpp"
#include "wristwise/visibility.hpp"

namespace WRISTWISE_PUBLIC wristwise {

/// In which frame deviations are measured.
enum class ToleranceFrame {
  path,  ///< that of the waypoint: the welder's angles
  base,  ///< the base frame (of the part's link, where a positioner moves it)
};

/// How far the TCP may deviate from a waypoint's frame, coordinate by coordinate.
///
/// The deviation is e = (x, y, z, alpha, beta, gamma), m and rad: the position of the TCP in the
/// tolerance frame, and Euler angles about the moving axes x, y, z (design: R = Rx Ry Rz).
/// With ToleranceFrame::path they are the angles of R_p^T R_ee and the position in the path frame;
/// with ToleranceFrame::base the wrapped differences of the angles of R_ee and R_p, and the
/// position difference along the base axes (F3).
struct ToleranceBox {
  /// The bound, with its sign, of a rotation that may have any value.
  static constexpr double kFree = std::numeric_limits<double>::infinity();

  ToleranceFrame frame = ToleranceFrame::path;  ///< in which deviations are measured
  Vector6 lower = Vector6::Zero();              ///< m, rad; -infinity where free
  Vector6 upper = Vector6::Zero();              ///< m, rad; +infinity where free

  /// Whether a coordinate (0 to 5: x, y, z, rx, ry, rz) is a rotation without bounds.
  bool is_free(int coordinate) const;

  /// The Euler sequence of the box: the free angle comes last, a bounded one in the middle.
  EulerSequence sequence() const;

  /// @throws InvalidInput where a bound is NaN, lower > upper, a position is unbounded, a rotation
  /// is bounded on one side only, or the middle angle's bound is 90 deg or more. `where` names the
  /// input in the message.
  void validate(const std::string& where) const;

  /// The same box, wider by `position` (m) and `angle` (rad) on each side.
  ToleranceBox widened(double position, double angle) const;
};

/// Names of the coordinates of a deviation, as in problem files.
inline constexpr std::array<const char*, 6> kCoordinateNames = {"x", "y", "z", "rx", "ry", "rz"};

/// The deviation e (m, rad) of a TCP pose from the path frame, both in the base frame (F3).
Vector6 deviation(const ToleranceBox& box, const Pose& path_frame, const Pose& tcp);

/// The pose (base frame) that deviates by e (m, rad) from the path frame: the inverse of
/// `deviation` where e's middle angle stays within +-90 deg.
Pose pose_at_deviation(const ToleranceBox& box, const Pose& path_frame, const Vector6& deviation);

/// d e / d q, 6 x n (m and rad per rad or m), from the geometric Jacobian of the TCP in the base
/// frame (F4). Near a middle angle of +-90 deg: see euler_rate_matrix.
Jacobian deviation_jacobian(const ToleranceBox& box, const Pose& path_frame, const Pose& tcp,
                            const Jacobian& geometric);

/// How far e lies outside the box, coordinate by coordinate, m and rad, >= 0; zero inside.
Vector6 box_excess(const ToleranceBox& box, const Vector6& deviation);

}  // namespace wristwise
