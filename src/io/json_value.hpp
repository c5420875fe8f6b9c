#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "wristwise/clearance.hpp"
#include "wristwise/problem.hpp"

namespace wristwise::json {

using Json = nlohmann::ordered_json;

/// Null where it is not finite.
Json number(double value);
Json number(const std::optional<double>& value);

/// A count that may not fit an integer.
Json count(double value);

/// Null where there is no such joint.
Json joint_name(const Problem& problem, int joint);

/// Null where both are empty.
Json names(const ClearanceModel::Names& pair);

/// {"x": ..., ..., "rz": ...}
Json coordinates(const Vector6& values);

}  // namespace wristwise::json
