#pragma once

#include <filesystem>
#include <string>

#include "wristwise/plan.hpp"

namespace wristwise::app {

/// Writes the pictures of --plot where they are asked for; see write_motion_pictures().
/// @return lines that say which
std::string write_pictures(bool asked_for, const std::filesystem::path& folder,
                           const Problem& problem, const PlanResult& result,
                           const PlanResult* graph_only = nullptr);

}  // namespace wristwise::app
