#pragma once

#include <functional>

#include "timing/uniform_speed.hpp"
#include "wristwise/plan.hpp"

namespace wristwise {

/// Whether a check failed by velocity, acceleration and jerk alone.
bool fails_by_rates_only(const Verification& verification);

/// Plans a problem that is run slower, in `factor` times the time.
using SlowerTrial =
    std::function<PlanResult(const Problem& slower, double factor, const PlanOptions&)>;

/// "infeasible_at_this_speed": where, which joint, by how much; and, found by trying, the highest
/// uniform speed that works.
/// @param task of the problem, with the waypoints of the motion
/// @throws Cancelled
Diagnosis diagnose_speed(const Problem& problem, const Task& task, const UniformSlowdown& too_fast,
                         const PlanOptions& options, const SlowerTrial& trial);

}  // namespace wristwise
