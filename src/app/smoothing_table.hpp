#pragma once

#include <string>

#include "app/paint.hpp"
#include "wristwise/plan.hpp"

namespace wristwise::app {

/// What smooth was given beside what it made of it: peaks of each joint, and what violates a limit,
/// a tolerance or a clearance. Empty where nothing was smoothed.
std::string smoothing_table(const PlanResult& result, const Problem& problem, const Paint& paint);

}  // namespace wristwise::app
