#include "io/json_peaks.hpp"

#include <array>
#include <nlohmann/json.hpp>

#include "io/json_verification.hpp"
#include "io/peaks.hpp"

namespace wristwise::json {

namespace {

/// The peaks of joint j: value and share of the limit for each of the three derivatives.
Json joint_peaks(const std::array<std::optional<JointVector>, 3>& peaks, const Robot& robot,
                 int j) {
  constexpr std::array<const char*, 3> kNames = {"velocity", "acceleration", "jerk"};
  Json json = Json::object();
  for (std::size_t k = 0; k < kNames.size(); ++k) {
    const double limit = derivative_limits(robot, static_cast<int>(k) + 1)[j];
    json[kNames[k]] = peaks[k] ? number((*peaks[k])[j]) : Json(nullptr);
    json[std::string(kNames[k]) + "_ratio"] =
        peaks[k] ? number((*peaks[k])[j] / limit) : Json(nullptr);
  }
  return json;
}

/// One side of before and after.
Json side(const std::array<std::optional<JointVector>, 3>& peaks, const Verification& verification,
          const Problem& problem) {
  Json joints = Json::object();
  for (int j = 0; j < problem.robot->joint_count(); ++j)
    joints[problem.robot->joints()[static_cast<std::size_t>(j)].name] =
        joint_peaks(peaks, *problem.robot, j);
  const std::vector<std::string> violations = violations_of(verification);
  return {{"peaks", std::move(joints)},
          {"violation_count", violations.size()},
          {"violations", violations},
          {"verification", json::verification(verification, problem)}};
}

}  // namespace

Json peaks(const JointPath& path, const Problem& problem) {
  Json json = Json::object();
  if (!problem.robot) return json;
  const std::array<std::optional<JointVector>, 3> peaks = {
      peak_derivative(path, 1), peak_derivative(path, 2), peak_derivative(path, 3)};
  for (int j = 0; j < problem.robot->joint_count(); ++j) {
    const auto of_joint = [j](const std::optional<JointVector>& peak) {
      return peak ? number((*peak)[j]) : Json(nullptr);
    };
    json[problem.robot->joints()[static_cast<std::size_t>(j)].name] = {
        {"velocity", of_joint(peaks[0])},
        {"acceleration", of_joint(peaks[1])},
        {"jerk", of_joint(peaks[2])}};
  }
  return json;
}

Json before(const PlanResult& result, const Problem& problem) {
  if (!result.before || !problem.robot) return nullptr;
  const JointPath& path = result.before->path;
  return side({peak_derivative(path, 1), peak_derivative(path, 2), peak_derivative(path, 3)},
              result.before->verification, problem);
}

Json after(const PlanResult& result, const Problem& problem) {
  if (!result.before || result.trajectory.empty() || !problem.robot) return nullptr;
  const Trajectory& curve = result.trajectory;
  return side({peak_derivative(curve, 1), peak_derivative(curve, 2), peak_derivative(curve, 3)},
              result.verification, problem);
}

}  // namespace wristwise::json
