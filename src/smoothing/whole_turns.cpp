#include "smoothing/whole_turns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace wristwise {

namespace {

constexpr double kTurn = 6.28318530717958647692;  // rad
constexpr double kSlack = 0.1;                    // rad by which a recorded angle may pass a limit

/// The values of one joint.
struct Course {
  std::vector<double> values;
  std::vector<std::size_t> jumps;  ///< points after which there was one
};

/// The course without its jumps, starting where the path starts.
Course unwrapped_course(const JointPath& path, int joint, double max_velocity) {
  Course course;
  course.values.reserve(path.size());
  double shift = 0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const double value = path.positions[i][joint];
    if (i > 0) {
      const double step = value - path.positions[i - 1][joint];
      const double possible = max_velocity * (path.times[i] - path.times[i - 1]);
      if (std::abs(step) > std::max(0.5 * kTurn, possible)) {
        shift -= kTurn * std::round(step / kTurn);
        course.jumps.push_back(i - 1);
      }
    }
    course.values.push_back(value + shift);
  }
  return course;
}

/// The least shift by whole turns that brings the values inside the limits, if there is one.
std::optional<double> shift_inside(const Course& course, const Joint& joint) {
  const auto [least, largest] = std::minmax_element(course.values.begin(), course.values.end());
  const double fewest = std::ceil((joint.lower - kSlack - *least) / kTurn);
  const double most = std::floor((joint.upper + kSlack - *largest) / kTurn);
  if (fewest > most) return std::nullopt;
  return kTurn * std::clamp(0.0, fewest, most);
}

}  // namespace

Unwrapped without_whole_turns(const Robot& robot, const JointPath& path) {
  Unwrapped result{path, {}};
  for (int j = 0; j < robot.joint_count(); ++j) {
    const Joint& joint = robot.joints()[static_cast<std::size_t>(j)];
    if (joint.type == JointType::prismatic) continue;
    const Course course = unwrapped_course(path, j, joint.max_velocity);
    if (course.jumps.empty()) continue;
    const auto shift = shift_inside(course, joint);
    if (shift) {
      for (std::size_t i = 0; i < path.size(); ++i)
        result.path.positions[i][j] = course.values[i] + *shift;
    }
    result.warnings.push_back(fmt::format(
        "{} jumps by about whole turns {} time{}, first after {:.6g} s: {}", joint.name,
        course.jumps.size(), course.jumps.size() == 1 ? "" : "s", path.times[course.jumps.front()],
        shift ? "taken as wrapped angles and undone"
              : "left, as its limits leave no room to undo that"));
  }
  return result;
}

}  // namespace wristwise
