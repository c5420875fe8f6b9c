#include "io/json_diagnosis.hpp"

#include <nlohmann/json.hpp>

namespace wristwise::json {

namespace {

Json counts(const FailureCounts& counts) {
  Json collision = Json::array();
  for (const auto& [pair, count] : counts.collision) {
    collision.push_back({{"pair", names(pair)}, {"postures", count}});
  }
  return {{"samples", counts.samples},         {"out_of_reach", counts.out_of_reach},
          {"joint_limit", counts.joint_limit}, {"collision", std::move(collision)},
          {"usable", counts.usable},           {"too_fast", counts.too_fast},
          {"too_far", counts.too_far},         {"astray", counts.astray},
          {"blocked", counts.blocked}};
}

}  // namespace

Json diagnosis(const std::vector<Diagnosis>& diagnosis) {
  Json json = Json::array();
  for (const Diagnosis& entry : diagnosis)
    json.push_back({{"waypoint", entry.waypoint ? Json(*entry.waypoint) : Json(nullptr)},
                    {"reason", entry.reason},
                    {"detail", entry.detail},
                    {"suggestion", entry.suggestion},
                    {"counts", entry.counts ? counts(*entry.counts) : Json(nullptr)}});
  return json;
}

}  // namespace wristwise::json
