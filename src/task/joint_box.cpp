#include "wristwise/joint_box.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "wristwise/error.hpp"
#include "wristwise/robot.hpp"

namespace wristwise {

namespace {

void check_size(Eigen::Index size, const Robot& robot, const std::string& where) {
  if (size != robot.joint_count())
    throw InvalidInput(where, fmt::format("{} joint values", size),
                       fmt::format("{}", robot.joint_count()));
}

std::string shown(double lower, double upper) {
  return lower == upper ? fmt::format("{}", lower) : fmt::format("[{}, {}]", lower, upper);
}

void cut_to_limits(const Joint& joint, const std::string& where, double& lower, double& upper) {
  if (std::isnan(lower) || std::isnan(upper))
    throw InvalidInput(where, joint.name + " is not a number", "a value or [lower, upper]");
  if (lower > upper)
    throw InvalidInput(
        where,
        fmt::format("{}: the lower bound {} is above the upper, {}", joint.name, lower, upper),
        "[lower, upper]");
  if (upper < joint.lower || lower > joint.upper)
    throw InvalidInput(
        where, fmt::format("{} = {} is outside its limits", joint.name, shown(lower, upper)),
        fmt::format("{} to {}", joint.lower, joint.upper));
  lower = std::max(lower, joint.lower);
  upper = std::min(upper, joint.upper);
  if (!std::isfinite(lower) || !std::isfinite(upper))
    throw InvalidInput(where, fmt::format("{} = {} is not finite", joint.name, shown(lower, upper)),
                       "finite bounds for a joint without limits");
}

}  // namespace

JointVector JointBox::nominal() const { return lower + 0.5 * (upper - lower); }

JointBox cut_to_limits(const Robot& robot, const JointBox& box, const std::string& where) {
  check_size(box.lower.size(), robot, where);
  check_size(box.upper.size(), robot, where);
  JointBox inside = box;
  for (int j = 0; j < robot.joint_count(); ++j) {
    cut_to_limits(robot.joints()[static_cast<std::size_t>(j)], where, inside.lower[j],
                  inside.upper[j]);
  }
  return inside;
}

}  // namespace wristwise
