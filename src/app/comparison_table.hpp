#pragma once

#include <string>

#include "wristwise/plan.hpp"

namespace wristwise::app {

/// Graph-only beside two-stage, one line per measure.
std::string comparison_table(const PlanResult& graph_only, const PlanResult& two_stage,
                             const Problem& problem);

}  // namespace wristwise::app
