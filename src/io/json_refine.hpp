#pragma once

#include "io/json_value.hpp"
#include "wristwise/plan.hpp"

namespace wristwise::json {

/// The "refine" object of result.json.
Json refine(const RefineStatistics& refine);

}  // namespace wristwise::json
