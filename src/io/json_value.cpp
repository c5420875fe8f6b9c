#include "io/json_value.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace wristwise::json {

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json number(const std::optional<double>& value) { return value ? number(*value) : Json(nullptr); }

Json count(double value) {
  constexpr double kLargest = 9007199254740992.0;  // 2^53: beyond it doubles skip integers
  if (value >= 0 && value < kLargest && value == std::floor(value))
    return static_cast<std::int64_t>(value);
  return number(value);
}

Json joint_name(const Problem& problem, int joint) {
  if (!problem.robot || joint < 0 || joint >= problem.robot->joint_count()) return nullptr;
  return problem.robot->joints()[static_cast<std::size_t>(joint)].name;
}

Json names(const ClearanceModel::Names& pair) {
  if (pair.first.empty() && pair.second.empty()) return nullptr;
  return Json::array({pair.first, pair.second});
}

Json coordinates(const Vector6& values) {
  Json json = Json::object();
  for (int i = 0; i < 6; ++i)
    json[kCoordinateNames[static_cast<std::size_t>(i)]] = number(values[i]);
  return json;
}

}  // namespace wristwise::json
