#pragma once

#include <string>

#include "app/paint.hpp"
#include "wristwise/plan.hpp"

namespace wristwise::app {

/// Graph-only beside two-stage, one line per measure.
std::string comparison_table(const PlanResult& graph_only, const PlanResult& two_stage,
                             const Problem& problem, const Paint& paint);

}  // namespace wristwise::app
