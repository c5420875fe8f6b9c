#pragma once

#include <array>
#include <limits>
#include <string>

#include "wristwise/joints.hpp"
#include "wristwise/pose.hpp"
#include "wristwise/visibility.hpp"

namespace WRISTWISE_PUBLIC wristwise {

enum class ToleranceFrame { path, base };

/// How far the TCP may deviate from a waypoint's frame, coordinate by coordinate.
///
/// The deviation is e = (x, y, z, alpha, beta, gamma), m and rad: the position of the TCP in the
/// tolerance frame, and Euler angles about the moving axes x, y, z (design: R = Rx Ry Rz).
/// With ToleranceFrame::path they are the angles of R_p^T R_ee and the position in the path frame;
/// with ToleranceFrame::base the wrapped differences of the angles of R_ee and R_p, and the
/// position difference along the base axes (F3).
struct ToleranceBox {
  static constexpr double kFree = std::numeric_limits<double>::infinity();

  ToleranceFrame frame = ToleranceFrame::path;
  Vector6 lower = Vector6::Zero();  ///< m, rad; -infinity where free
  Vector6 upper = Vector6::Zero();  ///< m, rad; +infinity where free

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

inline constexpr std::array<const char*, 6> kCoordinateNames = {"x", "y", "z", "rx", "ry", "rz"};

/// The deviation e of a TCP pose from the path frame (F3).
Vector6 deviation(const ToleranceBox& box, const Pose& path_frame, const Pose& tcp);

/// The pose that deviates by e from the path frame: the inverse of `deviation` where e's middle
/// angle stays within +-90 deg.
Pose pose_at_deviation(const ToleranceBox& box, const Pose& path_frame, const Vector6& deviation);

/// d e / d q, 6 x n, from the geometric Jacobian of the TCP in the base frame (F4).
Jacobian deviation_jacobian(const ToleranceBox& box, const Pose& path_frame, const Pose& tcp,
                            const Jacobian& geometric);

/// How far e lies outside the box, coordinate by coordinate, >= 0; zero inside.
Vector6 box_excess(const ToleranceBox& box, const Vector6& deviation);

}  // namespace wristwise
