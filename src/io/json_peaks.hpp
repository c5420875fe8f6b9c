#pragma once

#include "io/json_value.hpp"
#include "wristwise/plan.hpp"

namespace wristwise::json {

/// The "peaks" object of result.json: of each joint, by divided differences.
Json peaks(const JointPath& path, const Problem& problem);

/// What smooth was given, by divided differences. Null where there is none.
Json before(const PlanResult& result, const Problem& problem);

/// What it made of that, for all t.
Json after(const PlanResult& result, const Problem& problem);

}  // namespace wristwise::json
