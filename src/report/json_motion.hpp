#pragma once

#include "io/json_value.hpp"
#include "report/motion_samples.hpp"
#include "wristwise/trajectory.hpp"

namespace wristwise::json {

/// What is written to trajectory.csv: times, positions and, of a curve, their first two
/// derivatives.
Json knots(const Trajectory& trajectory);
Json knots(const JointPath& path);

Json samples(const MotionSamples& samples, const ClearanceModel& model);

}  // namespace wristwise::json
