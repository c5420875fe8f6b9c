#pragma once

#include <optional>

#include "timing/uniform_speed.hpp"
#include "wristwise/plan.hpp"

namespace wristwise {

/// Whether a check failed by velocity, acceleration and jerk alone.
bool fails_by_rates_only(const Verification& verification);

/// "infeasible_at_this_speed": where, which joint, by how much.
Diagnosis diagnose_speed(const Robot& robot, const Task& task, const UniformSlowdown& too_fast);

/// What slower weld speed works; nullopt where none was found.
std::string suggest_speed(const Task& task, const UniformSlowdown& too_fast,
                          std::optional<double> factor);

}  // namespace wristwise
