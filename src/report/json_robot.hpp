#pragma once

#include "io/json_value.hpp"

namespace wristwise::json {

/// The chain, and the link that stands still.
Json robot(const Robot& robot);

/// Everything that has a shape: links, then objects.
Json bodies(const ClearanceModel& model, std::size_t object_count);

}  // namespace wristwise::json
