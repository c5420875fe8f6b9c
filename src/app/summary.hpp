#pragma once

#include <string>

#include "app/paint.hpp"
#include "wristwise/plan.hpp"

namespace wristwise::app {

/// What was planned, for people.
std::string summary(const PlanResult& result, const Problem& problem, const Paint& paint);

}  // namespace wristwise::app
