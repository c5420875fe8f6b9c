#include "export/controller_axes.hpp"

#include <fmt/format.h>

#include <limits>

#include "wristwise/error.hpp"

namespace wristwise {

namespace {

constexpr double kDegree = 0.017453292519943295;
constexpr double kMillimetre = 1e-3;
constexpr const char* kWhere = "export.joints";

double unit(bool slides) { return slides ? kMillimetre : kDegree; }

/// Turning joints in order on A1 ..., sliding ones on E1 ...
std::vector<ControllerAxis> obvious_axes(const Robot& robot) {
  std::vector<ControllerAxis> axes;
  int turning = 0, sliding = 0;
  for (const Joint& joint : robot.joints()) {
    const bool slides = joint.type == JointType::prismatic;
    axes.push_back({slides ? static_cast<int>(kRobotAxes) + sliding++ : turning++});
  }
  if (turning > static_cast<int>(kRobotAxes) || sliding > static_cast<int>(kExternalAxes))
    throw InvalidInput(kWhere,
                       fmt::format("not given, and the chain has {} turning and {} sliding joints",
                                   turning, sliding),
                       "an axis A1 to A6 or E1 to E6 for each joint");
  return axes;
}

}  // namespace

AxisValues no_axes() {
  AxisValues values;
  values.fill(std::numeric_limits<double>::quiet_NaN());
  return values;
}

std::string axis_name(std::size_t axis) {
  return axis < kRobotAxes ? fmt::format("A{}", axis + 1)
                           : fmt::format("E{}", axis - kRobotAxes + 1);
}

ControllerAxes::ControllerAxes(const Robot& robot, const std::vector<ControllerAxis>& axes)
    : axes_(axes.empty() ? obvious_axes(robot) : axes) {
  joint_of_.fill(-1);
  if (axes_.size() != robot.joints().size())
    throw InvalidInput(kWhere, fmt::format("{} axes", axes_.size()),
                       fmt::format("one for each of the {} joints", robot.joints().size()));
  for (std::size_t j = 0; j < axes_.size(); ++j) {
    const ControllerAxis& axis = axes_[j];
    if (axis.number < 0 || axis.number >= static_cast<int>(joint_of_.size()))
      throw InvalidInput(kWhere, fmt::format("axis number {}", axis.number), "0 to 11");
    if (axis.sign != 1 && axis.sign != -1)
      throw InvalidInput(kWhere, fmt::format("the sign {}", axis.sign), "1 or -1");
    if (!std::isfinite(axis.offset))
      throw InvalidInput(kWhere, "an offset that is not finite", "a number");
    const auto number = static_cast<std::size_t>(axis.number);
    if (has(number))
      throw InvalidInput(
          kWhere,
          fmt::format("both {} and {} are {}",
                      robot.joints()[static_cast<std::size_t>(joint_of_[number])].name,
                      robot.joints()[j].name, axis_name(number)),
          "an axis of its own for each joint");
    joint_of_[number] = static_cast<int>(j);
    slides_[number] = robot.joints()[j].type == JointType::prismatic;
  }
}

AxisValues ControllerAxes::values(const JointVector& joints) const {
  AxisValues values = no_axes();
  for (std::size_t axis = 0; axis < values.size(); ++axis) {
    if (!has(axis)) continue;
    const ControllerAxis& map = axes_[static_cast<std::size_t>(joint_of_[axis])];
    values[axis] = (map.sign * joints[joint_of_[axis]] + map.offset) / unit(slides_[axis]);
  }
  return values;
}

JointVector ControllerAxes::joints(const AxisValues& values, const std::string& where) const {
  JointVector joints(static_cast<Eigen::Index>(axes_.size()));
  for (std::size_t axis = 0; axis < values.size(); ++axis) {
    if (!has(axis)) continue;
    if (!std::isfinite(values[axis]))
      throw InvalidInput(where, "no value for axis " + axis_name(axis), "one for each joint");
    const ControllerAxis& map = axes_[static_cast<std::size_t>(joint_of_[axis])];
    joints[joint_of_[axis]] = map.sign * (values[axis] * unit(slides_[axis]) - map.offset);
  }
  return joints;
}

AxisValues coupled(AxisValues values, int coupling) {
  if (std::isfinite(values[1]) && std::isfinite(values[2])) values[2] += coupling * values[1];
  return values;
}

AxisValues uncoupled(AxisValues values, int coupling) { return coupled(values, -coupling); }

}  // namespace wristwise
