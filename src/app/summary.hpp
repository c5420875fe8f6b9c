#pragma once

#include <filesystem>
#include <string>

#include "wristwise/plan.hpp"

namespace wristwise::app {

/// What was planned and where it is, for people.
std::string summary(const PlanResult& result, const Problem& problem,
                    const std::filesystem::path& folder);

}  // namespace wristwise::app
