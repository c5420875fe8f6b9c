#include "io/peaks.hpp"

namespace wristwise {

std::optional<JointVector> peak_derivative(const JointPath& path, int order) {
  if (path.size() <= static_cast<std::size_t>(order)) return std::nullopt;
  JointVector peak = JointVector::Zero(path.positions.front().size());
  for (const JointVector& value : divided_differences(path, order))
    peak = peak.cwiseMax(value.cwiseAbs());
  return peak;
}

JointVector peak_derivative(const Trajectory& trajectory, int order) {
  JointVector peak = JointVector::Zero(trajectory.positions().front().size());
  JointVector least, largest;
  for (std::size_t i = 0; i + 1 < trajectory.times().size(); ++i) {
    trajectory.extremes(i, order, least, largest);
    peak = peak.cwiseMax(largest).cwiseMax(-least);
  }
  return peak;
}

JointVector derivative_limits(const Robot& robot, int order) {
  if (order == 1) return robot.velocity_limits();
  return order == 2 ? robot.acceleration_limits() : robot.jerk_limits();
}

}  // namespace wristwise
