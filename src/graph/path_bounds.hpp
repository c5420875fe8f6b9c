#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "graph/joint_metric.hpp"
#include "graph/neighbour_tree.hpp"
#include "graph/rung.hpp"
#include "wristwise/monitor.hpp"

namespace wristwise {

/// Lower bounds on the cost of the best path through each vertex of a ladder graph, from the metric
/// and the vertex costs alone: edge filters and checks can only make a path dearer (F19).
class PathBounds {
 public:
  /// Whether a configuration is known not to be usable.
  using IsBlocked = std::function<bool(std::size_t rung, Eigen::Index index)>;

  /// @param stride every stride-th rung is looked at first; 1 for squared costs
  /// @param is_blocked must outlive the bounds; what it knows later makes corridors narrower
  /// @pre every rung has a vertex
  PathBounds(const std::vector<Rung>& rungs, const JointMetric& metric, std::size_t stride,
             IsBlocked is_blocked, int threads, const Monitor& monitor);

  /// No path costs less.
  double least() const { return least_; }

  /// The vertices through which a path of at most `limit` may lead: every one for which the bound
  /// does not exceed it, but on each rung at most the `widest` that promise most.
  /// nullopt where the bounds show that there is no such path.
  std::optional<Corridor> corridor(double limit, std::size_t widest) const;

  std::size_t evaluated() const { return evaluated_; }  ///< edges looked at

 private:
  /// What is left of a rung, with bounds on the cost up to a vertex and from it on.
  struct Stop {
    std::vector<Eigen::Index> alive;
    Eigen::ArrayXd before;  ///< including the vertex's own cost
    Eigen::ArrayXd after;   ///< excluding it
  };
  struct Source;  // a stop as a tree

  void run_forward(int threads, const Monitor& monitor);
  bool run_backward(double limit, std::size_t widest, std::vector<Stop>& stops) const;
  std::optional<Stop> between(const Source& from, const Source& to, std::size_t rung, double limit,
                              std::size_t widest, std::size_t& evaluated) const;
  Source source(std::size_t rung, const Stop& stop, bool forward) const;
  static void keep_best(Stop& stop, std::size_t widest);
  Eigen::ArrayXd spare_cost(std::size_t rung) const;

  const std::vector<Rung>& rungs_;
  JointMetric metric_;
  IsBlocked is_blocked_;
  int threads_;
  std::vector<double> least_cost_;       ///< of each rung's vertices
  double base_ = 0;                      ///< their sum
  std::vector<std::size_t> landmarks_;   ///< rungs
  std::vector<Eigen::ArrayXd> forward_;  ///< of each landmark
  double least_ = kInfinity;
  mutable std::size_t evaluated_ = 0;
};

}  // namespace wristwise
