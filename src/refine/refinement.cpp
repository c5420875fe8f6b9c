#include "refine/refinement.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <utility>

#include "refine/active_constraints.hpp"
#include "refine/augmented_lagrangian.hpp"
#include "refine/breakpoints.hpp"
#include "refine/collocation.hpp"
#include "refine/dip_search.hpp"
#include "refine/seam_features.hpp"
#include "refine/seam_turning.hpp"

namespace wristwise {

namespace {

/// First mu, as a share of the seed's objective. A soft start lets the path leave the seam for a
/// while, and finds its way out of a spiky seed; a stiff one stays close to the seed.
constexpr std::array<double, 3> kStartShares = {1, 0.1, 100};
constexpr double kPointsOfUnitWeight = 50;  ///< the weight of a point is 1 where it stands for 1/50
constexpr double kFewestSpans = 48;
constexpr double kCoarsestSpans = 12;
constexpr double kMostSpans = 1e5;  ///< that long spans are cut into
constexpr std::size_t kCoarsening = 4;
constexpr double kTurningStep = 0.04;  ///< of the smoothing time
constexpr double kTurnOfASpan = 0.25;  ///< rad, of the seam
constexpr double kTurnOfACoarseSpan = 0.5;
constexpr double kSmoothingSpans = 20;  ///< the seed is smoothed over the duration / this, at least
constexpr int kPointsPerSpan = 3;
constexpr double kBetweenShare = 0.5;  ///< of the between-tolerance, at added points
constexpr int kMostSplits = 6;
constexpr double kSameTime = 1e-7;      ///< s
constexpr double kShortestSpan = 0.02;  ///< of the first spacing
constexpr Accuracy kCoarse{1e-3, 0.03, 1e-4, 8, false, 2};
constexpr double kSmall = 1e-4;  ///< m and rad; multipliers of smaller violations are worth keeping
constexpr double kWorthwhile = 0.7;  ///< of a violation that more knots leave over
constexpr int kVainSplits = 2;
constexpr double kStray = 1e-2;  ///< m and rad, in the first round

/// One run from a seed: coarse curves first, then the knots that the motion needs.
class Attempt {
 public:
  Attempt(const RefinementInput& input, const JointPath& seed, double start_share, const Stop& stop)
      : input_(input),
        stop_(stop),
        duration_(seed.times.back() - seed.times.front()),
        turning_(input.task, kTurningStep * input.options.smoothing_time),
        weights_(
            objective_weights(input.cost, input.options.smoothing_time, input.robot.joint_count())),
        checker_(input.clearance),
        collocation_(input.task),
        levels_(knot_levels(seed.times)),
        initial_(objective_terms(weights_, input.robot, input.task, seed)),
        lagrangian_(input, weights_, checker_, fit_spline(seed, levels_.front(), seed_smoothing()),
                    1) {
    const double objective = std::max(lagrangian_.terms().total(), 1e-6 / duration_);
    lagrangian_.set_first_mu(start_share * objective);
  }

  /// Minimises once, near the seam. Returns the decade of the mu that this took.
  long start() {
    place_points(0);
    lagrangian_.start_near(kStray, kCoarse, stop_);
    return std::lround(std::log10(lagrangian_.mu()));
  }

  /// From there to the end.
  Refined run() {
    for (std::size_t level = 0; level + 1 < levels_.size(); ++level) {
      if (level > 0) place_points(level);
      const Ending ending = lagrangian_.solve(kCoarse, stop_);
      if (ending == Ending::stopped) return finish("stopped");
      if (ending != Ending::converged) lagrangian_.soften();
    }
    if (levels_.size() > 1) place_points(levels_.size() - 1);
    if (!collocation_.is_complete() && !look_at_the_rest()) return finish("stopped");
    switch (solve_finely()) {
      case Ending::converged:
        remember();
        return finish("converged");
      case Ending::stopped:
        return finish("stopped");
      case Ending::out_of_rounds:
        return finish("round limit");
      default:
        return finish("the constraints can't be met together");
    }
  }

 private:
  double unit() const { return duration_ / kPointsOfUnitWeight; }

  double spacing() const {
    const RefineOptions& options = input_.options;
    if (options.knot_spacing > 0) return options.knot_spacing;
    return std::min(0.4 * options.smoothing_time, duration_ / kFewestSpans);
  }

  /// The steps of the sampling grid in a seed say nothing about the motion.
  double seed_smoothing() const {
    const double spans = std::max(kSmoothingSpans, turning_.total() / kTurnOfASpan);
    return std::min(0.4 * input_.options.smoothing_time, duration_ / spans);
  }

  /// Breakpoints from coarse to fine, each a subset of the next.
  std::vector<std::vector<double>> knot_levels(const std::vector<double>& times) const {
    std::vector<std::vector<double>> levels = {finest_level(times)};
    while (static_cast<double>(levels.back().size() - 1) >= kCoarsening * kCoarsestSpans) {
      std::vector<double> coarser =
          every_nth(levels.back(), kCoarsening, turning_, kTurnOfACoarseSpan);
      if (2 * coarser.size() > levels.back().size()) break;
      levels.push_back(std::move(coarser));
    }
    std::reverse(levels.begin(), levels.end());
    return levels;
  }

  /// At waypoints, which are then the rows of the result. A seam with stops, rounded corners or
  /// runs needs knots, and so rows, between them.
  std::vector<double> finest_level(const std::vector<double>& times) const {
    const std::vector<double> breakpoints =
        input_.options.knot_spacing > 0
            ? choose_breakpoints(times, spacing())
            : choose_breakpoints(times, spacing(), turning_, kTurnOfASpan);
    const std::vector<SeamFeature> features = seam_features(input_.task, spacing());
    if (features.empty()) return breakpoints;
    const bool at_waypoints =
        std::none_of(features.begin(), features.end(),
                     [](const SeamFeature& feature) { return feature.off_waypoint; });
    if (at_waypoints) return moved_to(times, graded(breakpoints, features));
    const double longest = std::max(spacing(), duration_ / kMostSpans);
    return graded(with_long_spans_cut(breakpoints, longest), features);
  }

  void place_points(std::size_t level) {
    if (level > 0) lagrangian_.use_breakpoints(levels_[level]);
    auto& points = lagrangian_.points();
    points = collocation_.choose(lagrangian_.spline().basis, kPointsPerSpan, unit(), points);
    lagrangian_.restart();
  }

  /// Waypoints that were left out and will be needed join while mu is small: false if stopped.
  bool look_at_the_rest() {
    const Ending ending = lagrangian_.solve(kCoarse, stop_);
    if (ending == Ending::stopped) return false;
    if (ending != Ending::converged) lagrangian_.soften();
    lagrangian_.add_points(collocation_.violated(input_.robot, lagrangian_.spline(),
                                                 input_.options.constraint_tolerance, unit()));
    return true;
  }

  /// Until everything holds everywhere: more points where something is left out, more knots where
  /// the curve can't follow.
  Ending solve_finely() {
    Accuracy accuracy;
    accuracy.violation = input_.options.constraint_tolerance;
    int splits = 0, vain = 0;
    std::optional<AugmentedLagrangian::State> before_splits;
    double last_left = std::numeric_limits<double>::infinity();
    while (true) {
      accuracy.rounds = input_.options.max_rounds - lagrangian_.rounds();
      const Ending ending = lagrangian_.solve(accuracy, stop_, [this] {
        if (find_gaps().empty()) remember();
      });
      if (ending == Ending::stopped || ending == Ending::out_of_rounds) return ending;
      if (ending != Ending::converged) {
        const double violation = lagrangian_.violation();
        const double left = std::max(violation / kSmall, lagrangian_.rate_violation());
        vain = left > kWorthwhile * last_left ? vain + 1 : 0;
        last_left = left;
        if (!before_splits) before_splits = lagrangian_.state();
        if (vain < kVainSplits && ++splits <= kMostSplits && split_spans()) continue;
        if (accuracy.persistent) return ending;
        accuracy.persistent = true;
        lagrangian_.restore(*before_splits);
        splits = vain = 0;
        last_left = std::numeric_limits<double>::infinity();
        continue;
      }
      if (!add_points()) return ending;
    }
  }

  /// More knots where the constraints do not hold: at waypoints while there are some between the
  /// knots, as the rows of the result are then the waypoints alone.
  bool split_spans() {
    const auto& breakpoints = lagrangian_.spline().basis.breakpoints();
    const auto at = lagrangian_.violated_times(input_.options.constraint_tolerance);
    auto finer = split_at_places(breakpoints, at, waypoint_times());
    if (finer.size() == breakpoints.size())
      finer = split_in_halves(breakpoints, at, kShortestSpan * spacing());
    if (finer.size() == breakpoints.size()) return false;
    if (lagrangian_.violation() > kSmall) {
      lagrangian_.soften();
    } else if (lagrangian_.violation() > input_.options.constraint_tolerance) {
      lagrangian_.soften(at);
    }
    lagrangian_.use_breakpoints(std::move(finer));
    return true;
  }

  std::vector<double> waypoint_times() const {
    std::vector<double> times;
    for (const Waypoint& waypoint : input_.task.waypoints) times.push_back(waypoint.time);
    return times;
  }

  /// Constraint points at waypoints that were left out and do not hold, and at the worst dip of
  /// every interval that has one.
  std::vector<PointConstraint> find_gaps() {
    const Spline& spline = lagrangian_.spline();
    auto gaps =
        collocation_.violated(input_.robot, spline, input_.options.constraint_tolerance, unit());
    const double half = 0.5 * input_.options.clearance_epsilon;
    const double accepted = input_.clearance->clearance() + half;
    for (const Dip& dip : find_dips(input_.task, spline, checker_, accepted, half)) {
      gaps.push_back(
          constraint_between(input_.task, dip.interval, dip.time, kBetweenShare, spline.basis));
    }
    return gaps;
  }

  bool add_points() {
    const std::vector<PointConstraint> gaps = find_gaps();
    if (gaps.empty()) return false;
    lagrangian_.add_points(gaps);
    lagrangian_.relax();
    return true;
  }

  /// The motion holds everything: it is what an early stop returns.
  void remember() {
    const double objective = lagrangian_.terms().total();
    if (best_ && best_objective_ <= objective) return;
    best_ = lagrangian_.spline();
    best_objective_ = objective;
    best_violation_ = lagrangian_.violation();
  }

  Refined finish(const std::string& termination) {
    const Spline& motion = best_ ? *best_ : lagrangian_.spline();
    const ObjectiveTerms final_terms = objective_terms(weights_, input_.robot, input_.task, motion);
    RefineStatistics statistics;
    statistics.run = true;
    statistics.rounds = lagrangian_.rounds();
    statistics.iterations = lagrangian_.iterations();
    statistics.evaluations = lagrangian_.evaluations();
    statistics.control_points = motion.basis.control_count();
    statistics.constraint_points = static_cast<int>(lagrangian_.points().size());
    statistics.distance_queries = checker_.queries();
    statistics.max_violation = best_ ? best_violation_ : lagrangian_.violation();
    statistics.termination = termination;
    statistics.objective = final_terms.total();
    statistics.terms = {{"joint_motion", initial_.joint_motion, final_terms.joint_motion},
                        {"acceleration", initial_.acceleration, final_terms.acceleration},
                        {"jerk", initial_.jerk, final_terms.jerk},
                        {"euler", initial_.euler, final_terms.euler},
                        {"position", initial_.position, final_terms.position},
                        {"posture", initial_.posture, final_terms.posture},
                        {"singularity", initial_.singularity, final_terms.singularity}};
    if (!weights_.own.empty()) statistics.terms.push_back({"own", initial_.own, final_terms.own});
    if (termination == "converged") {
      statistics.active = active_constraints(*input_.clearance, motion, lagrangian_.points(),
                                             lagrangian_.limits(), statistics.objective);
    }
    return {motion.sampled_at(row_times(motion.basis)), best_.has_value(), stop_.requested(),
            statistics};
  }

  /// Of the waypoints and the knots between them. A knot that is a waypoint but for rounding is no
  /// row of its own: a quintic across it is the same curve.
  std::vector<double> row_times(const SplineBasis& basis) const {
    const std::vector<double> waypoints = waypoint_times();
    std::vector<double> times = waypoints;
    for (const double t : basis.breakpoints()) {
      const auto after = std::lower_bound(waypoints.begin(), waypoints.end(), t - kSameTime);
      if (after == waypoints.end() || *after > t + kSameTime) times.push_back(t);
    }
    std::sort(times.begin(), times.end());
    return times;
  }

  const RefinementInput& input_;
  const Stop& stop_;
  double duration_;
  SeamTurning turning_;
  ObjectiveWeights weights_;
  ClearanceChecker checker_;
  Collocation collocation_;
  std::vector<std::vector<double>> levels_;
  ObjectiveTerms initial_;
  AugmentedLagrangian lagrangian_;
  std::optional<Spline> best_;
  double best_objective_ = 0, best_violation_ = 0;
};

/// The way is there, but not at this speed: another start does not help.
bool fails_by_rates(const Refined& refined) {
  return !refined.feasible && refined.statistics.max_violation <= kSmall;
}

double initial_objective(const Refined& refined) {
  double sum = 0;
  for (const CostTerm& term : refined.statistics.terms) sum += term.initial;
  return sum;
}

}  // namespace

bool is_better(const Refined& a, const Refined& b) {
  if (a.feasible != b.feasible) return a.feasible;
  return a.feasible ? a.statistics.objective < b.statistics.objective
                    : a.statistics.max_violation < b.statistics.max_violation;
}

Refined refine(const RefinementInput& input, const JointPath& seed) {
  const Stop stop(input.monitor, input.options.time_limit);
  double progress = 0;  // of the attempt that came farthest: a bar does not go back
  Monitor monitor = input.monitor;
  if (monitor.progress) {
    monitor.progress = [&](const std::string& stage, double fraction) {
      progress = std::max(progress, fraction);
      input.monitor.report(stage, progress);
    };
  }
  const RefinementInput forward{input.robot, input.task,    input.clearance,
                                input.cost,  input.options, monitor};
  Refined best;
  int iterations = 0, evaluations = 0, rounds = 0;
  bool stopped = false;
  std::set<long> tried;
  for (const double share : kStartShares) {
    Attempt trial(forward, seed, share, stop);
    if (!tried.insert(trial.start()).second) continue;
    Refined attempt = trial.run();
    iterations += attempt.statistics.iterations;
    evaluations += attempt.statistics.evaluations;
    rounds += attempt.statistics.rounds;
    stopped = stopped || attempt.stopped;
    if (best.trajectory.empty() || is_better(attempt, best)) best = std::move(attempt);
    if (!best.feasible) throw_if_cancelled(input.monitor);
    if (best.feasible && best.statistics.objective <= initial_objective(best)) break;
    if (stop.requested() || fails_by_rates(best)) break;
  }
  best.stopped = stopped;
  best.statistics.iterations = iterations;
  best.statistics.evaluations = evaluations;
  best.statistics.rounds = rounds;
  return best;
}

}  // namespace wristwise
