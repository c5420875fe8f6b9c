#pragma once

#include "io/json_value.hpp"
#include "wristwise/plan.hpp"

namespace wristwise::json {

/// The "graph" object of result.json, with what each seed gave.
Json graph(const PlanResult& result);

}  // namespace wristwise::json
