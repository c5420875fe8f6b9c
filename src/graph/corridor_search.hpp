#pragma once

#include <optional>
#include <vector>

#include "graph/joint_metric.hpp"
#include "graph/known_checks.hpp"
#include "graph/ladder_graph.hpp"
#include "graph/neighbour_tree.hpp"

namespace wristwise {

/// The graph as the search sees it: every configuration once, with the shorter way round between
/// two of them, or every copy on its own.
struct SearchGraph {
  const std::vector<Rung>* rungs = nullptr;
  /// For each vertex the configuration that it is a copy of, increasing; empty: itself.
  std::vector<std::vector<Eigen::Index>> original;
  JointMetric metric;
  const EdgeRules* rules = nullptr;

  Eigen::Index configuration(std::size_t rung, Eigen::Index vertex) const {
    return original.empty() ? vertex : original[rung][static_cast<std::size_t>(vertex)];
  }
};

/// The least-cost path among some of the vertices: a forward dynamic programme whose best path is
/// checked and repaired until all of it can be used.
class CorridorSearch {
 public:
  struct Result {
    bool found = false;
    std::vector<Eigen::Index> vertices;  ///< where not found, to the last rung reached
    double cost = 0;
    double evaluated = 0;
  };

  CorridorSearch(const SearchGraph& graph, const Corridor& corridor, KnownChecks& known,
                 int threads, const Monitor& monitor);

  /// @param repair_part also check and repair a path that does not reach the last rung
  Result run(bool repair_part);

 private:
  struct Layer {
    Rung rung;                           ///< the vertices of the corridor; infinite cost if blocked
    std::vector<Eigen::Index> vertex;    ///< of the graph
    std::optional<NeighbourTree> tree;   ///< where there are many
    Eigen::ArrayXd distance;             ///< least cost
    std::vector<char> changed;           ///< since the interval that follows was relaxed
    std::vector<Eigen::Index> previous;  ///< on the layer before
    int blocked = 0;                     ///< times that a best path led through a blocked vertex
  };
  struct Interval {
    JointVector max_step;
    bool limited = false;
    int blocked = 0;
    bool check_all = false;
    bool stale = true;  ///< its moves have changed since it was relaxed
    bool fresh = true;  ///< every vertex at its end must be relaxed
  };
  struct Candidate {
    double total = kInfinity;
    Eigen::Index index = -1;
  };
  struct Scratch {  ///< of a thread
    Eigen::ArrayXd total;
    std::vector<Eigen::Index> order;
    KnownChecks::Moves fresh;
    std::size_t evaluated = 0;
  };

  void add_layer(std::size_t i, const std::vector<Eigen::Index>& vertices);
  void add_interval(std::size_t i);
  std::size_t relax_stale_intervals();
  void relax(std::size_t i);
  bool must_relax(std::size_t i, Eigen::Index v, int worker, Scratch& scratch);
  std::vector<Eigen::Index> chunk_starts(std::size_t i) const;
  void relax_vertex(std::size_t i, Eigen::Index v, int worker, Scratch& scratch);
  double measure_all(std::size_t i, const JointVector& target, Scratch& scratch);
  Candidate least_total(std::size_t i, const JointVector& target, Scratch& scratch);
  Candidate best_allowed(std::size_t i, Eigen::Index v, int worker, Scratch& scratch);

  bool is_allowed(std::size_t i, Eigen::Index u, Eigen::Index v, int worker, Scratch& scratch);
  bool is_clear(std::size_t i, Eigen::Index u, Eigen::Index v, int worker,
                KnownChecks::Moves& fresh) const;
  JointVector end_of_move(std::size_t i, Eigen::Index u, Eigen::Index v) const;
  Eigen::Index configuration(std::size_t i, Eigen::Index v) const;

  bool find_blocked_vertices(const std::vector<Eigen::Index>& path);
  void check_neighbours(std::size_t i, Eigen::Index v, int worker);
  void leave_out_blocked(std::size_t i);
  bool find_blocked_moves(const std::vector<Eigen::Index>& path);
  std::vector<Eigen::Index> best_path() const;

  const SearchGraph& graph_;
  const EdgeRules& rules_;
  KnownChecks& known_;
  const int threads_;
  const Monitor& monitor_;
  std::vector<Layer> layers_;
  std::vector<Interval> intervals_;
  std::size_t reached_ = 0;
  double evaluated_ = 0;
};

}  // namespace wristwise
