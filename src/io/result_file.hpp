#pragma once

#include <filesystem>
#include <string>

#include "wristwise/plan.hpp"

namespace wristwise {

/// The names that scripts know: "two-stage", "solved", ...
std::string mode_name(Mode mode);
std::string status_name(Status status);

/// The problem's task by the time law of the result.
Task task_as_run(const PlanResult& result, const Problem& problem);

/// The waypoints of the weld, without run-in and run-out.
std::size_t waypoint_count(const PlanResult& result, const Problem& problem);

/// result.json. @param problem may be empty where it could not be read
std::string result_json(const PlanResult& result, const Problem& problem);

/// The "verification" object of result.json.
std::string verification_json(const Verification& verification, const Problem& problem);

/// Makes the folder, writes result.json, and trajectory.csv and trajectory_dense.csv where the
/// result has them; those of an earlier result are removed.
/// @throws std::runtime_error where that fails
void write_result(const std::filesystem::path& folder, const PlanResult& result,
                  const Problem& problem);

}  // namespace wristwise
