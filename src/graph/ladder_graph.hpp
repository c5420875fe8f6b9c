#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <vector>

#include "wristwise/joints.hpp"
#include "wristwise/monitor.hpp"

namespace wristwise {

/// The vertices of one waypoint: configurations, one a row, with the cost of standing there.
/// The graph knows no robot.
struct Rung {
  Eigen::ArrayXXd positions;  ///< vertices x joints
  Eigen::ArrayXd cost;
  /// For each vertex, the first one that differs from it by whole turns of joints only, and a
  /// number for those turns such that equal differences of numbers mean equal differences of turns.
  /// Such vertices follow each other. Both empty: no two vertices are the same but for turns.
  std::vector<Eigen::Index> first_copy;
  std::vector<std::int64_t> turn_code;

  Eigen::Index size() const { return positions.rows(); }
  JointVector vertex(Eigen::Index index) const { return positions.row(index).transpose(); }
};

/// Which edges exist between neighbouring rungs, and what they cost:
/// cost(u, v) = sum_j weight_j |q_v,j - q_u,j|  (eq. 4 of De Maeyer et al., ETFA 2017).
struct EdgeRules {
  JointVector weight;
  std::vector<JointVector> max_step;  ///< for each interval, the largest step of each joint
  /// Whether the move is clear; asked only for edges that matter. Empty: every move is.
  /// Called from several threads, with a worker index below the number of threads.
  /// Turning a joint of both ends by whole turns must not change the answer.
  std::function<bool(int worker, std::size_t interval, const JointVector& from,
                     const JointVector& to)>
      is_clear;
};

struct LadderPath {
  bool found = false;
  /// The vertex on each rung; where no path exists, of the best path to the last rung reached.
  std::vector<Eigen::Index> vertices;
  double cost = 0;
  double edges = 0;            ///< of the whole graph
  double edges_evaluated = 0;  ///< cost computed
  std::size_t edges_checked = 0;
};

/// The least-cost path from the first rung to the last through edges that exist and are clear.
/// A forward dynamic programme, O(vertices) memory: equal to Dijkstra's optimum. Moves are checked
/// lazily: only those of the best path found, which is repaired until all of its moves are clear.
/// Among equal costs the lower vertex index wins, whatever the number of threads.
/// @pre every rung has a vertex
LadderPath find_least_cost_path(const std::vector<Rung>& rungs, const EdgeRules& rules, int threads,
                                const Monitor& monitor);

}  // namespace wristwise
