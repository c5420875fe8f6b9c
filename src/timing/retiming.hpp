#pragma once

#include "wristwise/seam.hpp"
#include "wristwise/trajectory.hpp"

namespace wristwise {

/// The nominal time of a task's seam over its real time, whether it has a law of its own or not.
Trajectory seam_time_of(const Task& task);

/// The task with its time run along a law: one joint, the task's present time over the new one.
Task run_along(const Task& task, const Trajectory& law);

/// The task in `factor` times the time.
Task stretched(const Task& task, double factor);

/// The same postures at the times of the task's waypoints.
/// @pre as many of them
JointPath at_waypoints_of(const Task& task, JointPath path);

}  // namespace wristwise
