#pragma once

#include <optional>
#include <vector>

#include "graph/ladder_graph.hpp"

namespace wristwise {

/// The number of copies of a configuration by whole turns between the limits, itself included.
std::size_t copy_count(const Rung& rung, const EdgeRules& rules, Eigen::Index index);

/// Every copy as a vertex of its own. A joint without limits has no end of copies: it keeps its
/// period, and its configurations stay as they are.
struct TurnCopies {
  std::vector<Rung> rungs;
  std::vector<std::vector<Eigen::Index>> original;  ///< for each vertex, what it is a copy of
  JointVector period;                               ///< of what is left to the metric
};
TurnCopies expand_turns(const std::vector<Rung>& rungs, const EdgeRules& rules);

/// The path through these configurations that goes the shorter way round at each step, shifted by
/// whole turns so that it stays between the limits, as far from them as possible; nullopt where
/// there is no such shift.
std::optional<std::vector<JointVector>> lift_turns(const std::vector<Rung>& rungs,
                                                   const EdgeRules& rules,
                                                   const std::vector<Eigen::Index>& vertices,
                                                   const JointVector& period);

}  // namespace wristwise
