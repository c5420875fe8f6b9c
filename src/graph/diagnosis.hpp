#pragma once

#include <optional>

#include "graph/move_checker.hpp"
#include "graph/path_sampling.hpp"
#include "wristwise/plan.hpp"

namespace wristwise {

/// Why the first waypoint without a vertex has none; nullopt where every waypoint has one.
std::optional<Diagnosis> diagnose_samples(const Robot& robot, const Task& task,
                                          const SampledPath& sampled);

/// Why no move leads on from the last rung that could be reached.
Diagnosis diagnose_moves(const Task& task, const SampledPath& sampled, const EdgeRules& rules,
                         const LadderPath& path, const MoveChecker& moves,
                         const std::shared_ptr<const ClearanceModel>& clearance,
                         double clearance_epsilon);

}  // namespace wristwise
