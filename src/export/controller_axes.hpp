#pragma once

#include <array>
#include <string>
#include <vector>

#include "wristwise/export_options.hpp"
#include "wristwise/robot.hpp"

namespace wristwise {

inline constexpr std::size_t kRobotAxes = 6, kExternalAxes = 6;

/// Values of the axes 1 to 6 of the robot, then E1 to E6: deg or mm; NaN where there is no such
/// axis.
using AxisValues = std::array<double, kRobotAxes + kExternalAxes>;

/// No axis at all.
AxisValues no_axes();

/// "A1" to "A6", "E1" to "E6"
std::string axis_name(std::size_t axis);

/// The joints of a chain as axes of a controller, and back.
class ControllerAxes {
 public:
  /// @throws InvalidInput naming `export.joints`: not one axis for each joint, an axis twice, a
  /// sign that is neither 1 nor -1; or none are given and which joint is which axis is not obvious.
  ControllerAxes(const Robot& robot, const std::vector<ControllerAxis>& axes);

  AxisValues values(const JointVector& joints) const;
  /// @throws InvalidInput at `where` naming an axis that is missing
  JointVector joints(const AxisValues& values, const std::string& where) const;

  const std::vector<ControllerAxis>& axes() const { return axes_; }  ///< one per joint
  bool has(std::size_t axis) const { return joint_of_[axis] >= 0; }
  bool slides(std::size_t axis) const { return slides_[axis]; }  ///< in mm

 private:
  std::vector<ControllerAxis> axes_;
  std::array<int, kRobotAxes + kExternalAxes> joint_of_{};  ///< -1: none
  std::array<bool, kRobotAxes + kExternalAxes> slides_{};
};

/// Fanuc's J3 counts from the horizontal: J3 + coupling * J2 in place of J3, and back.
AxisValues coupled(AxisValues values, int coupling);
AxisValues uncoupled(AxisValues values, int coupling);

}  // namespace wristwise
