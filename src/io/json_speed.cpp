#include "io/json_speed.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace wristwise::json {

Json speed_held(const PlanResult& result, const Problem& problem) {
  const Verification& verification = result.verification;
  const bool run = verification.run;
  Json slowed = Json::array();
  double slowest = 1;
  for (const SlowedStretch& stretch : result.slowed) {
    slowed.push_back({{"from_s", number(stretch.from)},
                      {"to_s", number(stretch.to)},
                      {"least_ratio", number(stretch.least_ratio)},
                      {"joint", joint_name(problem, stretch.joint)}});
    slowest = std::min(slowest, stretch.least_ratio);
  }
  return {{"ratio", run ? number(verification.velocity_ratio) : Json(nullptr)},
          {"worst_time_s", run ? number(verification.velocity_time) : Json(nullptr)},
          {"worst_joint", joint_name(problem, verification.velocity_joint)},
          {"slowest", number(slowest)},
          {"slowed", std::move(slowed)}};
}

}  // namespace wristwise::json
