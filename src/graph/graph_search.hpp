#pragma once

#include <memory>
#include <optional>

#include "graph/known_checks.hpp"
#include "graph/ladder_graph.hpp"
#include "graph/move_checker.hpp"
#include "graph/path_sampling.hpp"

namespace wristwise {

/// The search of stage 1 on the rungs of a task: edge costs and filters from the options, postures
/// and moves checked for clearance.
class GraphSearch {
 public:
  /// @param epsilon m, of the swept clearance check
  GraphSearch(const SamplingInput& input, const Task& task, double epsilon, int threads,
              const Monitor& monitor);

  /// Leaves it to the step limit alone which moves there are in some intervals.
  void check_moves_only_in(std::vector<bool> intervals);

  /// As if the seam were run slower by this factor, as far as joint speeds are concerned.
  void slow_down(double factor);

  /// @pre every rung has a vertex; as many as there are waypoints, or fewer
  LadderPath find_path(const std::vector<Rung>& rungs);

  /// The same for rungs that share their positions with those of `known`.
  LadderPath find_path(const std::vector<Rung>& rungs, KnownChecks& known);

  /// The same with one thread, given up where checks of moves have used up what is `left` of them.
  std::optional<LadderPath> find_path_within(std::size_t& left, const std::vector<Rung>& rungs,
                                             KnownChecks& known);

  const EdgeRules& rules() const { return rules_; }
  MoveChecker& moves() { return moves_; }
  const MoveChecker& moves() const { return moves_; }

 private:
  void set_costs(const CostOptions& cost, int joints);
  void set_filters(const SamplingInput& input, const Task& task);

  MoveChecker moves_;
  EdgeRules rules_;
  int threads_;
  const Monitor& monitor_;
};

}  // namespace wristwise
