#pragma once

#include <vector>

#include "io/json_value.hpp"
#include "wristwise/plan.hpp"

namespace wristwise::json {

/// The "diagnosis" list of result.json.
Json diagnosis(const std::vector<Diagnosis>& diagnosis);

}  // namespace wristwise::json
