#pragma once

#include "io/json_value.hpp"
#include "wristwise/verification.hpp"

namespace wristwise::json {

/// The "verification" object of result.json.
Json verification(const Verification& verification, const Problem& problem);

}  // namespace wristwise::json
