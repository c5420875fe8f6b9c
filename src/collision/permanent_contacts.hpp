#pragma once

#include <utility>
#include <vector>

#include "wristwise/clearance.hpp"

namespace wristwise {

/// Which of the pairs of bodies are nearer than `clearance` (m) in each of a fixed set of random
/// postures. For a pair that never moves one posture says it all.
std::vector<bool> permanent_contacts(const Robot& robot,
                                     const std::vector<ClearanceModel::Body>& bodies,
                                     const std::vector<std::pair<int, int>>& pairs,
                                     double clearance);

}  // namespace wristwise
