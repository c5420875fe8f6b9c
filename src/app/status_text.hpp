#pragma once

#include <string>

#include "app/paint.hpp"
#include "wristwise/plan.hpp"

namespace wristwise::app {

/// "solved", "infeasible", ...: green, red, or yellow where it was interrupted.
std::string status_text(Status status, const Paint& paint);

/// Why there is no trajectory, and what would help: two lines for each.
std::string diagnosis_text(const std::vector<Diagnosis>& diagnosis, const Paint& paint);

}  // namespace wristwise::app
