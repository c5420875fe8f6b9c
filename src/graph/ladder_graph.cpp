#include "graph/ladder_graph.hpp"

#include <algorithm>
#include <limits>
#include <unordered_map>

#include "cancelled.hpp"
#include "parallel.hpp"

namespace wristwise {

namespace {

constexpr double kUnreachable = std::numeric_limits<double>::infinity();

/// After this many blocked moves of best paths in one interval, the moves into every vertex of the
/// interval are checked during relaxation: each further search would only find the next blocked
/// one.
constexpr int kLazyAttempts = 8;

using KnownMoves = std::unordered_map<Eigen::Index, bool>;  ///< from vertex -> clear

class Search {
 public:
  Search(const std::vector<Rung>& rungs, const EdgeRules& rules, int threads,
         const Monitor& monitor)
      : rungs_(rungs),
        rules_(rules),
        threads_(threads),
        monitor_(monitor),
        states_(rungs.size()),
        intervals_(rungs.size() - 1) {
    states_[0].distance = rungs[0].cost;
  }

  LadderPath run() {
    std::size_t first_stale = 0;
    do {
      reached_ = relax_from(first_stale);
    } while (find_blocked_move(first_stale));
    return result();
  }

 private:
  /// Least cost of each vertex of a rung, and the vertex it is reached from.
  struct State {
    Eigen::ArrayXd distance;
    std::vector<Eigen::Index> predecessor;
  };
  struct Interval {
    std::vector<KnownMoves> known;  ///< for each vertex at the end of the interval
    int blocked = 0;
    bool check_all = false;
    std::size_t moves_checked = 0;
  };

  /// Relaxes the intervals from the given one on; returns the last rung that can be reached.
  std::size_t relax_from(std::size_t first) {
    for (std::size_t i = first; i + 1 < rungs_.size(); ++i) {
      throw_if_cancelled(monitor_);
      relax(i);
      monitor_.report("search",
                      static_cast<double>(i + 1) / static_cast<double>(rungs_.size() - 1));
      if (states_[i + 1].distance.minCoeff() == kUnreachable) return i;
    }
    return rungs_.size() - 1;
  }

  void relax(std::size_t i) {
    const Eigen::Index count = rungs_[i + 1].size();
    State& state = states_[i + 1];
    state.distance.resize(count);
    state.predecessor.resize(static_cast<std::size_t>(count));
    if (intervals_[i].known.empty()) intervals_[i].known.resize(static_cast<std::size_t>(count));
    edges_evaluated_ += static_cast<double>(count) * static_cast<double>(rungs_[i].size());

    constexpr Eigen::Index kChunk = 16;
    const auto chunks = static_cast<std::size_t>((count + kChunk - 1) / kChunk);
    std::vector<Eigen::ArrayXd> buffers(static_cast<std::size_t>(threads_));
    std::vector<std::size_t> checked(static_cast<std::size_t>(threads_), 0);
    parallel_for(chunks, threads_, [&](int worker, std::size_t chunk) {
      const Eigen::Index begin = static_cast<Eigen::Index>(chunk) * kChunk;
      const Eigen::Index end = std::min(begin + kChunk, count);
      for (Eigen::Index v = begin; v < end; ++v) {
        relax_vertex(i, v, worker, buffers[static_cast<std::size_t>(worker)],
                     checked[static_cast<std::size_t>(worker)]);
      }
    });
    for (const std::size_t n : checked) intervals_[i].moves_checked += n;
  }

  void relax_vertex(std::size_t i, Eigen::Index v, int worker, Eigen::ArrayXd& total,
                    std::size_t& checked) {
    const Rung& from = rungs_[i];
    const Rung& to = rungs_[i + 1];
    total = states_[i].distance;
    for (Eigen::Index j = 0; j < from.positions.cols(); ++j) {
      total += rules_.weight[j] * (from.positions.col(j) - to.positions(v, j)).abs();
    }
    const JointVector& max_step = rules_.max_step[i];
    for (Eigen::Index j = 0; j < from.positions.cols(); ++j) {
      if (max_step[j] == kUnreachable) continue;
      total = ((from.positions.col(j) - to.positions(v, j)).abs() > max_step[j])
                  .select(kUnreachable, total);
    }
    KnownMoves& known = intervals_[i].known[static_cast<std::size_t>(v)];
    for (const auto& [u, clear] : known) {
      if (!clear) total[u] = kUnreachable;
    }
    Eigen::Index best = 0;
    double least = total.minCoeff(&best);
    while (intervals_[i].check_all && least < kUnreachable &&
           !is_clear(i, best, v, worker, checked)) {
      total[best] = kUnreachable;
      least = total.minCoeff(&best);
    }
    states_[i + 1].distance[v] = least + to.cost[v];
    states_[i + 1].predecessor[static_cast<std::size_t>(v)] = best;
  }

  bool is_clear(std::size_t i, Eigen::Index u, Eigen::Index v, int worker, std::size_t& checked) {
    KnownMoves& known = intervals_[i].known[static_cast<std::size_t>(v)];
    const auto [entry, is_new] = known.try_emplace(u, true);
    if (is_new) {
      ++checked;
      entry->second = rules_.is_clear(worker, i, rungs_[i].vertex(u), rungs_[i + 1].vertex(v));
    }
    return entry->second;
  }

  /// Checks the moves of the best path found. Marks the blocked ones and returns true with the
  /// first of their intervals, from where the search must be repeated.
  bool find_blocked_move(std::size_t& first_blocked) {
    if (!rules_.is_clear) return false;
    bool any = false;
    const std::vector<Eigen::Index> vertices = best_vertices();
    for (std::size_t i = 0; i + 1 < vertices.size(); ++i) {
      Interval& interval = intervals_[i];
      if (is_clear(i, vertices[i], vertices[i + 1], 0, interval.moves_checked)) continue;
      if (!any) first_blocked = i;
      any = true;
      interval.check_all = ++interval.blocked >= kLazyAttempts;
    }
    return any;
  }

  std::vector<Eigen::Index> best_vertices() const {
    std::vector<Eigen::Index> vertices(reached_ + 1);
    states_[reached_].distance.minCoeff(&vertices[reached_]);
    for (std::size_t i = reached_; i > 0; --i) {
      vertices[i - 1] = states_[i].predecessor[static_cast<std::size_t>(vertices[i])];
    }
    return vertices;
  }

  LadderPath result() const {
    LadderPath path;
    path.found = reached_ + 1 == rungs_.size();
    path.vertices = best_vertices();
    path.cost = states_[reached_].distance[path.vertices.back()];
    path.edges_evaluated = edges_evaluated_;
    for (std::size_t i = 0; i + 1 < rungs_.size(); ++i) {
      path.edges +=
          static_cast<double>(rungs_[i].size()) * static_cast<double>(rungs_[i + 1].size());
      path.edges_checked += intervals_[i].moves_checked;
    }
    return path;
  }

  const std::vector<Rung>& rungs_;
  const EdgeRules& rules_;
  const int threads_;
  const Monitor& monitor_;
  std::vector<State> states_;
  std::vector<Interval> intervals_;
  std::size_t reached_ = 0;
  double edges_evaluated_ = 0;
};

}  // namespace

LadderPath find_least_cost_path(const std::vector<Rung>& rungs, const EdgeRules& rules, int threads,
                                const Monitor& monitor) {
  return Search(rungs, rules, threads, monitor).run();
}

}  // namespace wristwise
