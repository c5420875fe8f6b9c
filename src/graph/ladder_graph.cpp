#include "graph/ladder_graph.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "cancelled.hpp"
#include "graph/relaxation.hpp"
#include "parallel.hpp"

namespace wristwise {

namespace {

constexpr double kUnreachable = std::numeric_limits<double>::infinity();

/// After this many blocked moves of best paths in one interval, the moves into every vertex of the
/// interval are checked during relaxation: each further search would only find the next blocked
/// one.
constexpr int kLazyAttempts = 2;

/// A move that is the same for all copies of its ends that differ by the same turns.
struct Move {
  Eigen::Index from;   ///< first copy
  std::int64_t turns;  ///< turn code of the end less that of the start
  bool operator==(const Move& other) const { return from == other.from && turns == other.turns; }
};
struct MoveHash {
  std::size_t operator()(const Move& move) const {
    return std::hash<std::int64_t>()(move.turns * 1000003 + move.from);
  }
};
using KnownMoves = std::unordered_map<Move, bool, MoveHash>;  ///< -> clear

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
    for (std::size_t i = 0; i < intervals_.size(); ++i) {
      intervals_[i].known.resize(static_cast<std::size_t>(rungs[i + 1].size()));
      intervals_[i].max_step = binding_step(rungs[i], rungs[i + 1], rules.max_step[i]);
    }
  }

  LadderPath run() {
    do {
      reached_ = relax_stale_intervals();
    } while (find_blocked_moves());
    return result();
  }

 private:
  /// Least cost of each vertex of a rung, and the vertex it is reached from.
  struct State {
    Eigen::ArrayXd distance;
    std::vector<Eigen::Index> predecessor;
  };
  struct Interval {
    std::vector<KnownMoves> known;  ///< for each first copy at the end of the interval
    int blocked = 0;
    bool check_all = false;
    bool stale = true;  ///< its moves have changed since it was relaxed
    std::size_t moves_checked = 0;
    JointVector max_step;
  };
  /// What a thread works with.
  struct Scratch {
    Eigen::ArrayXd total;
    std::vector<Eigen::Index> order;
    std::size_t moves_checked = 0;
  };

  /// The step limit, infinite for joints that could not break it between these rungs.
  static JointVector binding_step(const Rung& from, const Rung& to, JointVector max_step) {
    for (int j = 0; j < max_step.size(); ++j) {
      const auto& a = from.positions.col(j);
      const auto& b = to.positions.col(j);
      const double largest = std::max(b.maxCoeff() - a.minCoeff(), a.maxCoeff() - b.minCoeff());
      if (largest <= max_step[j]) max_step[j] = kUnreachable;
    }
    return max_step;
  }

  /// Relaxes the intervals whose moves or start have changed; returns the last rung that can be
  /// reached.
  std::size_t relax_stale_intervals() {
    bool start_changed = false;
    for (std::size_t i = 0; i + 1 < rungs_.size(); ++i) {
      Eigen::ArrayXd& distance = states_[i + 1].distance;
      if (start_changed || intervals_[i].stale) {
        throw_if_cancelled(monitor_);
        Eigen::ArrayXd before;
        before.swap(distance);
        relax(i);
        intervals_[i].stale = false;
        start_changed = before.size() != distance.size() || (before != distance).any();
        monitor_.report("search",
                        static_cast<double>(i + 1) / static_cast<double>(rungs_.size() - 1));
      }
      if (distance.minCoeff() == kUnreachable) return i;
    }
    return rungs_.size() - 1;
  }

  void relax(std::size_t i) {
    const Eigen::Index count = rungs_[i + 1].size();
    State& state = states_[i + 1];
    state.distance.resize(count);
    state.predecessor.resize(static_cast<std::size_t>(count));
    edges_evaluated_ += static_cast<double>(count) * static_cast<double>(rungs_[i].size());

    const std::vector<Eigen::Index> chunks = chunk_starts(rungs_[i + 1]);
    std::vector<Scratch> scratch(static_cast<std::size_t>(threads_));
    parallel_for(chunks.size() - 1, threads_, [&](int worker, std::size_t chunk) {
      for (Eigen::Index v = chunks[chunk]; v < chunks[chunk + 1]; ++v) {
        relax_vertex(i, v, worker, scratch[static_cast<std::size_t>(worker)]);
      }
    });
    for (const Scratch& used : scratch) intervals_[i].moves_checked += used.moves_checked;
  }

  static Eigen::Index first_copy(const Rung& rung, Eigen::Index v) {
    return rung.first_copy.empty() ? v : rung.first_copy[static_cast<std::size_t>(v)];
  }
  static std::int64_t turn_code(const Rung& rung, Eigen::Index v) {
    return rung.turn_code.empty() ? 0 : rung.turn_code[static_cast<std::size_t>(v)];
  }

  /// Cuts a rung into chunks for the threads, never between copies of one posture: they share what
  /// is known of their moves.
  static std::vector<Eigen::Index> chunk_starts(const Rung& rung) {
    constexpr Eigen::Index kChunk = 16;
    std::vector<Eigen::Index> starts;
    for (Eigen::Index v = 0; v < rung.size(); ++v) {
      const bool is_due = starts.empty() || v - starts.back() >= kChunk;
      if (is_due && first_copy(rung, v) == v) starts.push_back(v);
    }
    starts.push_back(rung.size());
    return starts;
  }

  void relax_vertex(std::size_t i, Eigen::Index v, int worker, Scratch& scratch) {
    const Rung& from = rungs_[i];
    const Rung& to = rungs_[i + 1];
    scratch.total.resize(from.size());
    const JointVector target = to.vertex(v);
    double least = relax_towards({from.positions.data(), static_cast<std::size_t>(from.size()),
                                  static_cast<int>(from.positions.cols())},
                                 states_[i].distance.data(), target.data(), rules_.weight.data(),
                                 intervals_[i].max_step.data(), scratch.total.data());
    Eigen::Index best = 0;
    if (least < kUnreachable) {
      const double* const total = scratch.total.data();
      best = std::find(total, total + scratch.total.size(), least) - total;
      if (!is_allowed(i, best, v, worker, scratch.moves_checked)) {
        std::tie(best, least) = next_best(i, v, worker, scratch);
      }
    }
    states_[i + 1].distance[v] = least + to.cost[v];
    states_[i + 1].predecessor[static_cast<std::size_t>(v)] = best;
  }

  /// The cheapest vertex to come from by a move that is allowed.
  std::pair<Eigen::Index, double> next_best(std::size_t i, Eigen::Index v, int worker,
                                            Scratch& scratch) {
    const Eigen::ArrayXd& total = scratch.total;
    std::vector<Eigen::Index>& order = scratch.order;
    order.clear();
    for (Eigen::Index u = 0; u < total.size(); ++u) {
      if (total[u] < kUnreachable) order.push_back(u);
    }
    const auto is_worse = [&total](Eigen::Index a, Eigen::Index b) {
      return total[a] != total[b] ? total[a] > total[b] : a > b;
    };
    std::make_heap(order.begin(), order.end(), is_worse);
    for (auto end = order.end(); end != order.begin();) {
      std::pop_heap(order.begin(), end--, is_worse);
      if (is_allowed(i, *end, v, worker, scratch.moves_checked)) return {*end, total[*end]};
    }
    return {0, kUnreachable};
  }

  /// A move that is not known to be blocked; where the interval asks for it, known to be clear.
  bool is_allowed(std::size_t i, Eigen::Index u, Eigen::Index v, int worker,
                  std::size_t& moves_checked) {
    if (!rules_.is_clear) return true;
    if (intervals_[i].check_all) return is_clear(i, u, v, worker, moves_checked);
    const KnownMoves& known = known_moves(i, v);
    const auto entry = known.find(move(i, u, v));
    return entry == known.end() || entry->second;
  }

  Move move(std::size_t i, Eigen::Index u, Eigen::Index v) const {
    return {first_copy(rungs_[i], u), turn_code(rungs_[i + 1], v) - turn_code(rungs_[i], u)};
  }

  KnownMoves& known_moves(std::size_t i, Eigen::Index v) {
    return intervals_[i].known[static_cast<std::size_t>(first_copy(rungs_[i + 1], v))];
  }

  bool is_clear(std::size_t i, Eigen::Index u, Eigen::Index v, int worker,
                std::size_t& moves_checked) {
    const auto [entry, is_new] = known_moves(i, v).try_emplace(move(i, u, v), true);
    if (is_new) {
      ++moves_checked;
      entry->second = rules_.is_clear(worker, i, rungs_[i].vertex(u), rungs_[i + 1].vertex(v));
    }
    return entry->second;
  }

  /// Checks the moves of the best path found and marks the blocked ones; false if there are none.
  bool find_blocked_moves() {
    if (!rules_.is_clear) return false;
    bool any = false;
    const std::vector<Eigen::Index> vertices = best_vertices();
    for (std::size_t i = 0; i + 1 < vertices.size(); ++i) {
      Interval& interval = intervals_[i];
      if (is_clear(i, vertices[i], vertices[i + 1], 0, interval.moves_checked)) continue;
      any = interval.stale = true;
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
