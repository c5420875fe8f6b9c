#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "graph/rung.hpp"
#include "wristwise/joints.hpp"
#include "wristwise/monitor.hpp"

namespace wristwise {

/// Which edges exist between neighbouring rungs, and what they cost:
/// cost(u, v) = sum_j weight_j |q_v,j - q_u,j|  (eq. 4 of De Maeyer et al., ETFA 2017), or the sum
/// of weight_j (q_v,j - q_u,j)^2, plus what `edge_cost` adds.
struct EdgeRules {
  JointVector weight;
  bool squared = false;
  std::vector<JointVector> max_step;  ///< for each interval, the largest step of each joint

  /// rad; 2 pi for a joint of which every configuration stands for all its copies, shifted by whole
  /// turns, between `lower` and `upper` (either may be infinite); infinity: no copies. Positions of
  /// a joint with a period lie in [-period/2, period/2]. Empty: no joint has copies.
  JointVector period, lower, upper;

  /// Whether a move is short enough in a sense that whole turns do not change: cheap, asked for
  /// every move that may matter. Called from several threads. Empty: every one is.
  std::function<bool(std::size_t interval, const JointVector& from, const JointVector& to)> is_near;

  /// Whether a configuration, or the move between two, can be used; asked only for those that
  /// matter. Empty: every one can. Called from several threads, with a worker index below the
  /// number of threads. Turning a joint by whole turns (both ends of a move by the same) must not
  /// change the answer.
  std::function<bool(int worker, std::size_t rung, const JointVector& q)> is_usable;
  std::function<bool(int worker, std::size_t interval, const JointVector& from,
                     const JointVector& to)>
      is_clear;

  /// What is added, >= 0. May depend on the turns. Empty: nothing.
  std::function<double(std::size_t rung, const JointVector& q)> vertex_cost;
  std::function<double(std::size_t interval, const JointVector& from, const JointVector& to)>
      edge_cost;
};

class KnownChecks;

struct LadderStatistics {
  std::size_t vertices = 0;    ///< copies included
  double edges = 0;            ///< of the whole graph
  double edges_evaluated = 0;  ///< cost computed
  std::size_t usable_checks = 0;
  std::size_t clear_checks = 0;
};

struct LadderPath {
  bool found = false;
  /// The configuration on each rung, by index and with its turns; where no path exists, of the best
  /// path to the last rung reached.
  std::vector<Eigen::Index> vertices;
  std::vector<JointVector> positions;
  double cost = 0;
  LadderStatistics statistics;
};

/// The least-cost path from the first rung to the last through edges that exist and are clear:
/// Dijkstra's optimum. O(configurations) memory; neither edges nor copies are stored.
/// Configurations and moves are checked lazily: only those of the best path found, which is
/// repaired until all of it can be used.
/// The result does not depend on the number of threads.
/// A joint without limits goes the shorter way round at each step, even where that is blocked.
/// @pre every rung has a vertex, and every vertex has a copy between the limits
/// @param known what is known of configurations and moves, to be shared by searches on rungs with
/// the same positions; null: nothing
LadderPath find_least_cost_path(const std::vector<Rung>& rungs, const EdgeRules& rules, int threads,
                                const Monitor& monitor, KnownChecks* known = nullptr);

}  // namespace wristwise
