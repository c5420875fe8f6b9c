#include "io/json_refine.hpp"

#include <nlohmann/json.hpp>

namespace wristwise::json {

namespace {

std::string unit_name(ActiveConstraint::Unit unit) {
  switch (unit) {
    case ActiveConstraint::Unit::metre:
      return "m";
    case ActiveConstraint::Unit::radian:
      return "rad";
    case ActiveConstraint::Unit::share:
      break;
  }
  return "share of the limit";
}

Json active(const std::vector<ActiveConstraint>& constraints) {
  Json json = Json::array();
  for (const ActiveConstraint& constraint : constraints) {
    json.push_back({{"name", constraint.name},
                    {"from_s", number(constraint.from)},
                    {"to_s", number(constraint.to)},
                    {"relative_gain", number(constraint.relative_gain)},
                    {"per", unit_name(constraint.unit)},
                    {"sentence", constraint.sentence}});
  }
  return json;
}

}  // namespace

Json refine(const RefineStatistics& refine) {
  Json terms = Json::array();
  for (const CostTerm& term : refine.terms)
    terms.push_back(
        {{"name", term.name}, {"initial", number(term.initial)}, {"final", number(term.final)}});
  return {{"iterations", refine.iterations},
          {"evaluations", refine.evaluations},
          {"termination", refine.run ? refine.termination : "not run"},
          {"objective", refine.run ? number(refine.objective) : Json(nullptr)},
          {"terms", std::move(terms)},
          {"rounds", refine.rounds},
          {"control_points", refine.control_points},
          {"constraint_points", refine.constraint_points},
          {"distance_queries", refine.distance_queries},
          {"active", active(refine.active)},
          {"max_violation", refine.run ? number(refine.max_violation) : Json(nullptr)}};
}

}  // namespace wristwise::json
