#include "graph/ladder_graph.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "graph/corridor_search.hpp"
#include "graph/path_bounds.hpp"
#include "graph/turn_copies.hpp"

namespace wristwise {

// Three relaxations make an exact search cheap:
// - Copies. Without joint limits all copies of a path by whole turns cost the same. The search sees
//   each configuration once and goes the shorter way round; the path found is then shifted into the
//   limits. Where that works it is the optimum, as limits can only make a path dearer.
// - Skipped rungs (PathBounds) tell which vertices a path of limited cost may use at all.
// - Checks are left until a path needs them (CorridorSearch).

namespace {

JointVector or_infinite(const JointVector& period, Eigen::Index joints) {
  return period.size() > 0 ? period : JointVector::Constant(joints, kInfinity);
}

Corridor everything(const std::vector<Rung>& rungs) {
  Corridor corridor;
  for (const Rung& rung : rungs) {
    corridor.emplace_back(static_cast<std::size_t>(rung.size()));
    std::iota(corridor.back().begin(), corridor.back().end(), Eigen::Index{0});
  }
  return corridor;
}

bool is_narrower(const Corridor& corridor, std::size_t width) {
  return std::all_of(corridor.begin(), corridor.end(),
                     [width](const auto& rung) { return rung.size() < width; });
}

/// Finds the least-cost path in corridors: narrow ones, which give a path and so an upper bound,
/// then one that holds every path up to that bound. The more rungs the bounds look at, the narrower
/// that is, and the dearer are the bounds.
class LadderSearch {
 public:
  LadderSearch(const SearchGraph& graph, KnownChecks& known, int threads, const Monitor& monitor)
      : graph_(graph), known_(known), threads_(threads), monitor_(monitor) {
    for (const Rung& rung : *graph.rungs) {
      largest_ = std::max(largest_, static_cast<std::size_t>(rung.size()));
    }
  }

  CorridorSearch::Result run() {
    std::size_t stride = graph_.metric.squared ? 1 : kFirstStride;
    double slack = kFirstSlack;
    for (std::size_t width = kFirstWidth; stride > 0 && width < largest_;) {
      const std::size_t blocked_before = known_.blocked();
      PathBounds bounds(*graph_.rungs, graph_.metric, stride, is_blocked(), threads_, monitor_);
      const Attempt attempt = search_within(bounds, width, slack);
      evaluated_ += static_cast<double>(bounds.evaluated());
      if (attempt.best) return *attempt.best;
      if (!attempt.found_any) {
        width *= kWider;
        slack *= kWider;
      }
      if (attempt.found_any && known_.blocked() == blocked_before) stride /= 2;
    }
    return search(everything(*graph_.rungs), true);
  }

  double evaluated() const { return evaluated_; }

 private:
  static constexpr std::size_t kFirstStride = 4;
  static constexpr std::size_t kFirstWidth = 64;
  static constexpr double kFirstSlack = 0.1;  ///< relative to the bound
  static constexpr int kWider = 2;

  struct Attempt {
    bool found_any = false;
    std::optional<CorridorSearch::Result> best;  ///< where it is known to be the best of all
  };

  Attempt search_within(const PathBounds& bounds, std::size_t width, double slack) {
    if (bounds.least() == kInfinity) return {};
    double limit = 0;
    std::optional<Corridor> narrow;
    for (; !narrow; slack *= kWider) {
      if (slack > 1e6) return {};
      limit = bounds.least() + slack * (0.1 + std::abs(bounds.least()));
      narrow = bounds.corridor(limit, width);
    }
    const CorridorSearch::Result path = search(*narrow, false);
    if (!path.found) return {};
    if (is_narrower(*narrow, width) && path.cost <= limit) return {true, path};
    const std::size_t widest = largest_ / 2;
    const auto all = bounds.corridor(path.cost, widest);
    if (all && is_narrower(*all, widest)) return {true, search(*all, true)};
    return {true, std::nullopt};
  }

  PathBounds::IsBlocked is_blocked() const {
    return [this](std::size_t rung, Eigen::Index vertex) {
      return known_.is_blocked(rung, graph_.configuration(rung, vertex));
    };
  }

  CorridorSearch::Result search(const Corridor& corridor, bool repair_part) {
    CorridorSearch search(graph_, corridor, known_, threads_, monitor_);
    CorridorSearch::Result path = search.run(repair_part);
    evaluated_ += path.evaluated;
    return path;
  }

  const SearchGraph& graph_;
  KnownChecks& known_;
  const int threads_;
  const Monitor& monitor_;
  std::size_t largest_ = 0;
  double evaluated_ = 0;
};

class Search {
 public:
  Search(const std::vector<Rung>& rungs, const EdgeRules& rules, int threads,
         const Monitor& monitor, KnownChecks& known)
      : rungs_(rungs), rules_(rules), threads_(threads), monitor_(monitor), known_(known) {
    period_ = or_infinite(rules.period, rules.weight.size());
  }

  LadderPath run() {
    const bool turns_matter = rules_.vertex_cost || rules_.edge_cost;
    if (turns_matter || !find_without_copies()) find_with_copies();
    count();
    return std::move(path_);
  }

 private:
  /// false where limits or blocked moves make the copies matter.
  bool find_without_copies() {
    const SearchGraph graph{&rungs_, {}, {rules_.weight, period_, rules_.squared}, &rules_};
    const auto result = search(graph);
    if (!result.found && known_.any_move_blocked()) return false;
    const auto lifted = lift_turns(rungs_, rules_, result.vertices, period_);
    if (!lifted) return false;
    if (known_.any_move_blocked() && result.cost > least_of_long_way()) return false;
    path_.found = result.found;
    path_.vertices = result.vertices;
    path_.positions = *lifted;
    path_.cost = result.cost;
    return true;
  }

  /// A path that somewhere goes the longer way round costs at least this.
  double least_of_long_way() const {
    double base = 0, least = kInfinity;
    for (const Rung& rung : rungs_) base += rung.cost.minCoeff();
    for (Eigen::Index j = 0; j < period_.size(); ++j) {
      if (period_[j] == kInfinity) continue;
      const double half = period_[j] / 2;
      least = std::min(least, rules_.weight[j] * (rules_.squared ? half * half : half));
    }
    return base + least;
  }

  void find_with_copies() {
    if (search_copies(rules_) || search_copies(with_limits_for_rungs())) return;
    path_.found = false;
    path_.vertices.clear();
  }

  /// false where the path cannot be shifted into the limits of joints that keep their period.
  bool search_copies(const EdgeRules& rules) {
    TurnCopies copies = expand_turns(rungs_, rules);
    if (rules_.vertex_cost) add_vertex_cost(copies);
    const SearchGraph graph{
        &copies.rungs, copies.original, {rules_.weight, copies.period, rules_.squared}, &rules_};
    const auto result = search(graph);
    path_.found = result.found;
    path_.cost = result.cost;
    path_.vertices.clear();
    for (std::size_t i = 0; i < result.vertices.size(); ++i) {
      path_.vertices.push_back(graph.configuration(i, result.vertices[i]));
    }
    const auto lifted = lift_turns(copies.rungs, rules, result.vertices, copies.period);
    if (lifted) path_.positions = *lifted;
    return lifted.has_value();
  }

  /// Some rungs can ask for copies that the shorter way round does not reach. Limits then give
  /// their joints copies: one turn farther from what the rungs ask for than the path found winds.
  EdgeRules with_limits_for_rungs() const {
    EdgeRules rules = rules_;
    for (Eigen::Index j = 0; j < period_.size(); ++j) {
      if (std::isfinite(rules.lower[j]) && std::isfinite(rules.upper[j])) continue;
      double lowest = kInfinity, highest = -kInfinity;
      for (const Rung& rung : rungs_) {
        if (rung.lower.size() == 0 || period_[j] == kInfinity) continue;
        for (const double limit : {rung.lower[j], rung.upper[j]}) {
          if (std::isinf(limit)) continue;
          lowest = std::min(lowest, limit);
          highest = std::max(highest, limit);
        }
      }
      if (lowest > highest) continue;
      const double farther = winding(j) + period_[j];
      if (std::isinf(rules.lower[j])) rules.lower[j] = lowest - farther;
      if (std::isinf(rules.upper[j])) rules.upper[j] = highest + farther;
    }
    return rules;
  }

  /// From the lowest to the highest value of a joint on the path, going the shorter way round.
  double winding(Eigen::Index joint) const {
    double value = 0, lowest = 0, highest = 0;
    for (std::size_t i = 1; i < path_.vertices.size(); ++i) {
      value += std::remainder(rungs_[i].positions(path_.vertices[i], joint) -
                                  rungs_[i - 1].positions(path_.vertices[i - 1], joint),
                              period_[joint]);
      lowest = std::min(lowest, value);
      highest = std::max(highest, value);
    }
    return highest - lowest;
  }

  void add_vertex_cost(TurnCopies& copies) const {
    for (std::size_t i = 0; i < copies.rungs.size(); ++i) {
      Rung& rung = copies.rungs[i];
      for (Eigen::Index v = 0; v < rung.size(); ++v) {
        rung.cost[v] += rules_.vertex_cost(i, rung.vertex(v));
      }
    }
  }

  CorridorSearch::Result search(const SearchGraph& graph) {
    LadderSearch search(graph, known_, threads_, monitor_);
    auto result = search.run();
    path_.statistics.edges_evaluated += search.evaluated();
    return result;
  }

  void count() {
    LadderStatistics& statistics = path_.statistics;
    double previous = 0;
    for (const Rung& rung : rungs_) {
      std::size_t vertices = 0;
      for (Eigen::Index v = 0; v < rung.size(); ++v) vertices += copy_count(rung, rules_, v);
      statistics.vertices += vertices;
      statistics.edges += previous * static_cast<double>(vertices);
      previous = static_cast<double>(vertices);
    }
    statistics.usable_checks = known_.usable_checks();
    statistics.clear_checks = known_.clear_checks();
  }

  const std::vector<Rung>& rungs_;
  const EdgeRules& rules_;
  const int threads_;
  const Monitor& monitor_;
  KnownChecks& known_;
  JointVector period_;
  LadderPath path_;
};

}  // namespace

LadderPath find_least_cost_path(const std::vector<Rung>& rungs, const EdgeRules& rules, int threads,
                                const Monitor& monitor, KnownChecks* known) {
  if (known != nullptr) return Search(rungs, rules, threads, monitor, *known).run();
  KnownChecks own(rungs, rules);
  return Search(rungs, rules, threads, monitor, own).run();
}

}  // namespace wristwise
