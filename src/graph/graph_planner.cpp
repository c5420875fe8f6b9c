#include "graph/graph_planner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>

#include "graph/diagnosis.hpp"
#include "graph/grid_refinement.hpp"
#include "graph/reachable_pieces.hpp"
#include "graph/smallest_relaxation.hpp"
#include "graph/sparse_planner.hpp"
#include "stopwatch.hpp"

namespace wristwise {

namespace {

constexpr double kTurn = 6.28318530717958647692;
constexpr double kAnySpeed = 1e4;                 // times the time: no joint is too slow for a move
constexpr std::size_t kChecksAtAnySpeed = 10000;  // of moves

/// Searches are repeated, nobody knows how often. What they report as progress must not go back,
/// nor stand at its end before it is there: the first pass takes half of the way, each other one a
/// share of what is left.
class SearchProgress {
 public:
  double operator()(double fraction) {
    if (fraction < last_) {
      base_ = shown_;
      share_ = kLaterShare;
    }
    last_ = fraction;
    return shown_ = std::max(shown_, base_ + share_ * (1 - base_) * fraction);
  }

 private:
  static constexpr double kLaterShare = 0.04;

  double last_ = 0, base_ = 0, shown_ = 0, share_ = 0.5;
};

Monitor never_back(const Monitor& monitor) {
  Monitor result = monitor;
  if (!monitor.progress) return result;
  result.progress = [report = monitor.progress, search = std::make_shared<SearchProgress>()](
                        const std::string& stage, double fraction) {
    report(stage, stage == "search" ? (*search)(fraction) : fraction);
  };
  return result;
}

class GraphPlanner {
 public:
  GraphPlanner(const SamplingInput& input, const Task& task, double epsilon, int threads,
               const Monitor& monitor, Timing& timing, Speed speed)
      : input_(input),
        task_(task),
        epsilon_(epsilon),
        threads_(threads),
        monitor_(never_back(monitor)),
        timing_(timing),
        speed_(speed) {}

  GraphPlan run() {
    if (input_.options.planner == Planner::sparse) {
      run_sparse();
    } else {
      run_dense();
    }
    const bool explained = input_.options.planner == Planner::sparse;
    if (!plan_.found && !explained && plan_.diagnosis && plan_.diagnosis->waypoint) look_for_help();
    describe_best();
    return std::move(plan_);
  }

 private:
  void run_dense() {
    SampledPath sampled = sample();
    plan_.diagnosis = diagnose_samples(input_.robot, task_, sampled);
    const std::vector<Rung> rungs = rungs_to_search(sampled);
    if (rungs.empty()) return;
    GraphSearch search(input_, task_, epsilon_, threads_, monitor_);
    find_paths(search, rungs);
    plan_.statistics.collision_checks += search.moves().queries();
  }

  SampledPath sample() {
    const Stopwatch watch(timing_.sampling);
    SampledPath sampled = sample_path(input_, task_, threads_, monitor_);
    plan_.statistics.postures = sampled.postures;
    plan_.statistics.collision_checks = sampled.collision_checks;
    double previous = 0;
    for (const Rung& rung : sampled.rungs) {
      plan_.statistics.edges_if_eager += previous * static_cast<double>(rung.size());
      previous = static_cast<double>(rung.size());
    }
    return sampled;
  }

  /// Those before the first rung without a vertex.
  static std::vector<Rung> rungs_to_search(SampledPath& sampled) {
    const auto empty = std::find_if(sampled.rungs.begin(), sampled.rungs.end(),
                                    [](const Rung& rung) { return rung.size() == 0; });
    return {std::make_move_iterator(sampled.rungs.begin()), std::make_move_iterator(empty)};
  }

  void find_paths(GraphSearch& search, const std::vector<Rung>& rungs) {
    const Stopwatch watch(timing_.search);
    KnownChecks known(rungs, search.rules());
    LadderPath best = search.find_path(rungs, known);
    if (!best.found) plan_.diagnosis = diagnose_search(input_, task_, search, best, epsilon_);
    const bool whole = rungs.size() == task_.waypoints.size();
    if (whole && speed_ == Speed::any && is_too_fast())
      find_slower_path(search, rungs, known, best);
    plan_.found = best.found && whole;
    plan_.statistics.first_cost = best.cost;
    if (!plan_.found) return record(best, 0);
    std::vector<DistinctPath> paths = {{std::move(best), 0}};
    if (input_.options.seeds > 1) {
      const LadderPath first = paths.front().path;
      paths = find_distinct_paths(search, rungs, first, known,
                                  static_cast<std::size_t>(input_.options.seeds),
                                  input_.options.seed_separation);
    }
    for (DistinctPath& path : paths) {
      if (input_.options.coarse_to_fine) refine(search, path);
      record(path.path, path.differs_at);
    }
    std::stable_sort(plan_.seeds.begin(), plan_.seeds.end(),
                     [](const Seed& a, const Seed& b) { return a.cost < b.cost; });
  }

  bool is_too_fast() const {
    return plan_.diagnosis && plan_.diagnosis->counts && plan_.diagnosis->counts->too_fast > 0;
  }

  /// What the search at weld speed has checked is not checked again. Without an end it would look
  /// at every move between any two postures where there is no path at any speed.
  void find_slower_path(GraphSearch& search, const std::vector<Rung>& rungs, KnownChecks& known,
                        LadderPath& best) {
    search.slow_down(kAnySpeed);
    std::size_t left = kChecksAtAnySpeed;
    std::optional<LadderPath> slower = search.find_path_within(left, rungs, known);
    if (!slower || !slower->found) return;
    best = std::move(*slower);
    plan_.too_fast = true;
    plan_.diagnosis.reset();
  }

  /// Where there is no path: what would help, and which pieces can be welded.
  void look_for_help() {
    const Stopwatch watch(timing_.search);
    std::string help;
    if (input_.options.try_relaxations) {
      help = smallest_relaxation(input_, task_, *plan_.diagnosis->waypoint, is_too_fast(), epsilon_,
                                 monitor_);
    }
    if (!help.empty()) plan_.diagnosis->suggestion = help;
    const std::size_t reached = plan_.seeds.empty() ? 0 : plan_.seeds.front().path.size();
    plan_.statistics.pieces =
        reachable_pieces(input_, task_, reached, epsilon_, threads_, monitor_);
    plan_.diagnosis->detail += describe(plan_.statistics.pieces);
  }

  static std::string describe(const std::vector<std::pair<std::size_t, std::size_t>>& pieces) {
    std::string text;
    for (const auto& [first, last] : pieces) {
      text += fmt::format("{}{} to {}", text.empty() ? "; waypoints that can be welded: " : ", ",
                          first, last);
    }
    return text;
  }

  void refine(GraphSearch& search, DistinctPath& path) {
    FinerPath finer = refine_grid(search, input_, task_, std::move(path.path), threads_);
    path.path = std::move(finer.path);
    if (plan_.seeds.empty()) plan_.statistics.grid_rounds = finer.rounds;
  }

  void run_sparse() {
    SparsePath sparse;
    {
      const Stopwatch watch(timing_.search);
      sparse = plan_sparse(input_, task_, epsilon_, threads_, monitor_);
    }
    plan_.found = sparse.path.found;
    plan_.statistics.sparse_points = sparse.points.size();
    plan_.statistics.replans = sparse.replans;
    plan_.statistics.postures = sparse.postures;
    plan_.statistics.collision_checks = sparse.queries;
    record(sparse.path, 0);
    if (!plan_.found) explain_sparse();
  }

  /// What is wrong is said of the dense plan: the sparse one cannot do better.
  void explain_sparse() {
    GraphOptions options = input_.options;
    options.planner = Planner::dense;
    const SamplingInput dense{input_.robot, input_.ik, input_.clearance, input_.cost, options};
    GraphPlan plan =
        GraphPlanner(dense, task_, epsilon_, threads_, monitor_, timing_, speed_).run();
    plan_.diagnosis = plan.diagnosis;
    plan_.statistics.pieces = plan.statistics.pieces;
    if (!plan.found || plan.too_fast) plan_.seeds = plan.seeds;
    plan_.found = plan_.too_fast = plan.too_fast;
    if (plan_.diagnosis || !plan.found || plan.too_fast) return;
    plan_.diagnosis = Diagnosis{std::nullopt, "no_edge", "the sparse planner found no path",
                                "use planner: dense, which finds one"};
  }

  Seed seed(const LadderPath& path, std::size_t differs_at) const {
    Seed seed;
    seed.cost = path.cost;
    seed.differs_at = differs_at;
    for (std::size_t i = 0; i < path.positions.size(); ++i) {
      seed.path.times.push_back(task_.waypoints[i].time);
      seed.path.positions.push_back(path.positions[i]);
    }
    return seed;
  }

  void record(const LadderPath& path, std::size_t differs_at) {
    if (plan_.seeds.empty()) {
      GraphStatistics& statistics = plan_.statistics;
      statistics.vertices = path.statistics.vertices;
      statistics.edges = path.statistics.edges;
      statistics.edges_evaluated = path.statistics.edges_evaluated;
      statistics.postures_checked = path.statistics.usable_checks;
      statistics.edges_checked = path.statistics.clear_checks;
    }
    plan_.seeds.push_back(seed(path, differs_at));
  }

  /// Of the first seed, which becomes the path.
  void describe_best() {
    if (plan_.seeds.empty() || plan_.seeds.front().path.positions.empty()) return;
    GraphStatistics& statistics = plan_.statistics;
    const std::vector<JointVector>& q = plan_.seeds.front().path.positions;
    statistics.cost = plan_.seeds.front().cost;
    for (std::size_t i = 1; i < q.size(); ++i) {
      statistics.joint_motion_l1 += (q[i] - q[i - 1]).lpNorm<1>();
    }
    statistics.first_turns = turns(q.front());
    statistics.last_turns = turns(q.back());
  }

  std::vector<int> turns(const JointVector& q) const {
    std::vector<int> result;
    for (int j = 0; j < input_.robot.joint_count(); ++j) {
      const bool turns =
          input_.robot.joints()[static_cast<std::size_t>(j)].type != JointType::prismatic;
      const double whole = turns ? std::round((q[j] - wrap_angle(q[j])) / kTurn) : 0;
      result.push_back(static_cast<int>(whole));
    }
    return result;
  }

  const SamplingInput& input_;
  const Task& task_;
  const double epsilon_;
  const int threads_;
  const Monitor monitor_;
  Timing& timing_;
  const Speed speed_;
  GraphPlan plan_;
};

}  // namespace

GraphPlan plan_graph(const SamplingInput& input, const Task& task, double epsilon, int threads,
                     const Monitor& monitor, Timing& timing, Speed speed) {
  GraphPlan plan = GraphPlanner(input, task, epsilon, threads, monitor, timing, speed).run();
  monitor.report("search", 1);
  return plan;
}

}  // namespace wristwise
