#include "timing/retiming.hpp"

#include "timing/motion_rates.hpp"
#include "timing/uniform_speed.hpp"

namespace wristwise {

namespace {

Trajectory real_time_is_nominal(const Task& task) {
  const JointVector start = JointVector::Constant(1, task.seam.start_time());
  const JointVector end = JointVector::Constant(1, task.seam.end_time());
  const JointVector one = JointVector::Ones(1), zero = JointVector::Zero(1);
  return {{start[0], end[0]}, {start, end}, {one, one}, {zero, zero}};
}

}  // namespace

Trajectory seam_time_of(const Task& task) {
  return task.seam.is_retimed() ? task.seam.seam_time() : real_time_is_nominal(task);
}

Task run_along(const Task& task, const Trajectory& law) {
  return task.retimed(run_along(seam_time_of(task), law));
}

Task stretched(const Task& task, double factor) {
  return task.retimed(stretched(seam_time_of(task), factor));
}

JointPath at_waypoints_of(const Task& task, JointPath path) {
  for (std::size_t i = 0; i < path.size(); ++i) path.times[i] = task.waypoints[i].time;
  return path;
}

}  // namespace wristwise
