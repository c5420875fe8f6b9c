#pragma once

#include <optional>

#include "graph/graph_search.hpp"
#include "wristwise/plan.hpp"

namespace wristwise {

/// Why the first waypoint without a vertex has none; nullopt where every waypoint has one.
std::optional<Diagnosis> diagnose_samples(const Robot& robot, const Task& task,
                                          const SampledPath& sampled);

/// Why no move leads on from the last rung that could be reached.
Diagnosis diagnose_search(const SamplingInput& input, const Task& task, const GraphSearch& graph,
                          const LadderPath& path, double clearance_epsilon);

}  // namespace wristwise
