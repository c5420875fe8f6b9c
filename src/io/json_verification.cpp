#include "io/json_verification.hpp"

#include <nlohmann/json.hpp>

namespace wristwise::json {

namespace {

/// What is shown for all t, and where it is not.
Json certificate(const Verification& verification, const Problem& problem) {
  const bool run = verification.run;
  Json clearance_not_shown = Json::array(), tolerance_not_shown = Json::array();
  for (const auto& [range, pair] : verification.clearance_not_shown) {
    clearance_not_shown.push_back(
        {{"from_s", number(range.from)}, {"to_s", number(range.to)}, {"pair", names(pair)}});
  }
  for (const TimeRange& range : verification.deviation_not_shown)
    tolerance_not_shown.push_back({{"from_s", number(range.from)}, {"to_s", number(range.to)}});
  const auto if_run = [run](const Json& value) { return run ? value : Json(nullptr); };
  return {{"from_s", if_run(number(verification.range.from))},
          {"to_s", if_run(number(verification.range.to))},
          {"shown",
           verification.clearance ? Json(verification.clearance_bound.has_value()) : Json(nullptr)},
          {"clearance_m", number(verification.clearance_bound)},
          {"epsilon_m", number(problem.refine.clearance_epsilon)},
          {"not_shown", std::move(clearance_not_shown)},
          {"tolerance_shown", if_run(verification.deviation_shown)},
          {"tolerance_not_shown", std::move(tolerance_not_shown)},
          {"path_error_m", if_run(number(verification.path_error))},
          {"path_error_rad", if_run(number(verification.angle_error))}};
}

}  // namespace

Json verification(const Verification& verification, const Problem& problem) {
  const bool run = verification.run;
  const auto if_run = [run](double value) { return run ? number(value) : Json(nullptr); };
  return {
      {"passed", verification.passed},
      {"position_error_m", if_run(verification.position_error)},
      {"tolerance_excess", coordinates(verification.tolerance_excess)},
      {"clearance_m", number(verification.clearance)},
      {"clearance_pair", names(verification.clearance_pair)},
      {"clearance_time_s", verification.clearance ? number(verification.clearance_time) : nullptr},
      {"joint_limit_excess", if_run(verification.joint_limit_excess)},
      {"velocity_ratio", if_run(verification.velocity_ratio)},
      {"acceleration_ratio", if_run(verification.acceleration_ratio)},
      {"jerk_ratio", if_run(verification.jerk_ratio)},
      {"samples", verification.samples},
      {"distance_queries", verification.distance_queries},
      {"run", run},
      {"curve", verification.curve},
      {"tolerance_excess_between", coordinates(verification.tolerance_excess_between)},
      {"clearance_required_m", problem.scene.scope == CollisionScope::off
                                   ? Json(nullptr)
                                   : number(problem.scene.clearance)},
      {"clearance_bound_m", number(verification.clearance_bound)},
      {"clearance_epsilon_m", number(problem.refine.clearance_epsilon)},
      {"certificate", certificate(verification, problem)},
      {"velocity_joint", joint_name(problem, verification.velocity_joint)},
      {"acceleration_joint", joint_name(problem, verification.acceleration_joint)},
      {"jerk_joint", joint_name(problem, verification.jerk_joint)},
      {"failures", verification.failures},
      {"warnings", verification.warnings}};
}

}  // namespace wristwise::json
