#pragma once

#include <memory>

#include "graph/ladder_graph.hpp"
#include "graph/move_checker.hpp"
#include "graph/path_sampling.hpp"

namespace wristwise {

/// The search of stage 1 on the rungs of a task: edge costs and filters from the options, moves and
/// postures checked for clearance.
class GraphSearch {
 public:
  /// @param epsilon m, of the swept clearance check
  GraphSearch(const SamplingInput& input, const Task& task, double epsilon, int threads,
              const Monitor& monitor);

  /// @pre every rung has a vertex; as many as there are waypoints, or fewer
  LadderPath find_path(const std::vector<Rung>& rungs);

  const EdgeRules& rules() const { return rules_; }
  const MoveChecker& moves() const { return moves_; }

 private:
  void set_filters(const Task& task);
  void set_costs();

  const SamplingInput input_;
  MoveChecker moves_;
  EdgeRules rules_;
  int threads_;
  const Monitor& monitor_;
};

}  // namespace wristwise
