#pragma once

#include "io/json_value.hpp"
#include "wristwise/plan.hpp"

namespace wristwise::json {

/// The "speed_held" object of result.json.
Json speed_held(const PlanResult& result, const Problem& problem);

}  // namespace wristwise::json
