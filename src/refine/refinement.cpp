#include "refine/refinement.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "cancelled.hpp"
#include "refine/dip_search.hpp"
#include "refine/spline_solver.hpp"

namespace wristwise {

namespace {

/// First mu, as a share of the seed's objective. A soft start lets the path leave the seam for a
/// while, and finds its way out of a spiky seed; a stiff one stays close to the seed.
constexpr std::array<double, 3> kStartShares = {1, 0.1, 100};
constexpr double kGrowth = 10;     ///< of mu in a round that gains too little
constexpr double kMuRange = 1e12;  ///< largest mu / first mu
constexpr double kFloor = 1e-4;  ///< m and rad; a violation that stalls below this wants more knots
constexpr double kSoftening = 1e-4;      ///< of mu when the curve gets more knots
constexpr double kRateShare = 0.1;       ///< first mu of rates, as a share of the objective
constexpr double kRateTolerance = 5e-4;  ///< of rates, half the margin they are kept by
constexpr double kBand = 0.02;           ///< m; pairs that are nearer than this get a constraint
constexpr double kBetweenShare = 0.5;    ///< of the between-tolerance, at added points
constexpr int kStalledRounds = 2;
constexpr int kPatience = 2;  ///< rounds in which the inner solver may run out of iterations
constexpr double kFewestSpans = 100;
constexpr double kTurnOfASpan = 0.25;  ///< rad, of the seam
constexpr double kSettled = 1e-4;      ///< relative change of the objective between rounds

/// Constraints that share a unit, and so a penalty parameter.
struct Group {
  double first_mu = 0;
  double mu = 0;
  double violation = 0;  ///< largest, in the last round
  double best_violation = INFINITY;
  int stalled = 0;

  void raise(double value) { violation = std::max(violation, value); }

  /// After a round that left a violation: larger mu where it gained too little. False where that
  /// does not help any more: the curve has too few knots, or there is no solution.
  bool tighten() {
    const bool stalls = violation > 0.5 * best_violation;
    stalled = stalls && violation < kFloor ? stalled + 1 : 0;
    if (mu >= kMuRange * first_mu || stalled >= kStalledRounds) return false;
    if (violation > 0.1 * best_violation) mu *= kGrowth;
    best_violation = std::min(best_violation, violation);
    return true;
  }

  void restart() {
    best_violation = INFINITY;
    stalled = 0;
  }

  void soften() {
    restart();
    mu = std::max(first_mu, kSoftening * mu);
  }
};

/// How far the direction of travel turns along the waypoints, rad.
double seam_turning(const Task& task) {
  double turning = 0;
  Eigen::Vector3d last = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i + 1 < task.waypoints.size(); ++i) {
    const Eigen::Vector3d step =
        task.waypoints[i + 1].frame.translation() - task.waypoints[i].frame.translation();
    turning += std::atan2(last.cross(step).norm(), last.dot(step));
    last = step;
  }
  return turning;
}

/// One run of the augmented Lagrangian from a seed.
class Attempt {
 public:
  Attempt(const RefinementInput& input, const JointPath& seed, double start_share)
      : input_(input),
        weights_(
            objective_weights(input.cost, input.options.smoothing_time, input.robot.joint_count())),
        checker_(input.clearance),
        required_(input.clearance->clearance() + input.options.clearance_epsilon),
        spacing_(first_spacing(seed)),
        spline_(fit_spline(seed, choose_breakpoints(seed.times, spacing_), seed_smoothing(seed))) {
    initial_ = objective_terms(weights_, input.robot, input.task, seed);
    const double duration = seed.times.back() - seed.times.front();
    places_.first_mu = places_.mu = start_share * std::max(terms().total(), 1e-6 / duration);
    for (const Waypoint& waypoint : input.task.waypoints) {
      points_.push_back(constraint_at_waypoint(waypoint, spline_.basis));
    }
    prepare_basis();
  }

  Refined run() {
    double last_objective = initial_.total();
    int unsettled = 0;
    for (round_ = 0; round_ < input_.options.max_rounds; ++round_) {
      input_.monitor.report("refine", static_cast<double>(round_) / input_.options.max_rounds);
      add_near_pairs_everywhere();
      const bool settled_inside = minimise_once();
      measure();
      const double objective = terms().total();
      const bool settled =
          settled_inside && std::abs(objective - last_objective) <= kSettled * objective;
      last_objective = objective;
      if (!holds() || !settled) {
        update_multipliers();
        unsettled = settled_inside ? 0 : unsettled + 1;
        const bool is_due = settled_inside || unsettled > kPatience;
        if (is_due && !tighten(objective))
          return finish(false, "the constraints can't be met together");
      } else if (!add_dips()) {
        return finish(true, "converged");
      } else {
        places_.restart();
        rates_.restart();
      }
    }
    return finish(holds() && !add_dips(), "round limit");
  }

 private:
  double first_spacing(const JointPath& seed) const {
    const RefineOptions& options = input_.options;
    if (options.knot_spacing > 0) return options.knot_spacing;
    const double duration = seed.times.back() - seed.times.front();
    const double spans = std::max(kFewestSpans, seam_turning(input_.task) / kTurnOfASpan);
    return std::min(0.4 * options.smoothing_time, duration / spans);
  }

  /// The steps of the sampling grid in a seed say nothing about the motion.
  double seed_smoothing(const JointPath& seed) const {
    const double duration = seed.times.back() - seed.times.front();
    const double spans = std::max(20.0, seam_turning(input_.task) / kTurnOfASpan);
    return std::min(0.4 * input_.options.smoothing_time, duration / spans);
  }

  void prepare_basis() {
    span_factors_ = span_factors(weights_, spline_.basis);
    euler_points_ = euler_points(weights_, input_.task, spline_.basis);
    limits_ = limit_constraints(input_.robot, spline_.basis);
    for (PointConstraint& point : points_) point.basis = spline_.basis.at(point.time);
  }

  /// Twice as many knots, where there are waypoints to put them on. The curve is kept.
  bool refine_knots() {
    const auto count = spline_.basis.breakpoints().size();
    std::vector<double> times;
    JointPath current;
    for (const Waypoint& waypoint : input_.task.waypoints) {
      current.times.push_back(waypoint.time);
      current.positions.push_back(spline_.evaluate(waypoint.time));
    }
    spacing_ *= 0.5;
    auto breakpoints = choose_breakpoints(current.times, spacing_);
    if (breakpoints.size() <= count) return false;
    spline_ = fit_spline(current, std::move(breakpoints));
    prepare_basis();
    forget_multipliers();
    places_.soften();
    rates_.soften();
    return true;
  }

  void add_near_pairs_everywhere() {
    for (PointConstraint& point : points_) {
      add_near_pairs(point, checker_, spline_.evaluate(point.time), required_, kBand);
    }
  }

  bool minimise_once() {
    const AugmentedProblem problem{input_.robot,  checker_,      weights_.joint,
                                   span_factors_, euler_points_, points_,
                                   limits_,       places_.mu,    rates_.mu};
    const InnerSummary inner =
        minimise(problem, spline_, input_.options.max_iterations, 1e-8, input_.monitor);
    statistics_.iterations += inner.iterations;
    statistics_.evaluations += inner.evaluations;
    return inner.converged;
  }

  /// Finds the largest violations; keeps the values for the update of the multipliers.
  void measure() {
    places_.violation = rates_.violation = 0;
    values_.resize(points_.size());
    for (std::size_t i = 0; i < points_.size(); ++i) {
      PointConstraint& point = points_[i];
      evaluate(point, checker_, spline_.evaluate(point.time), places_.mu, false, values_[i]);
      for (std::size_t r = 0; r < point.rows.size(); ++r) {
        places_.raise(point.rows[r].bounds.violation(values_[i].c[static_cast<Eigen::Index>(r)]));
      }
    }
    for (const LimitConstraint& limit : limits_) {
      for (std::size_t r = 0; r < limit.rows.size(); ++r) {
        group_of(limit).raise(limit.rows[r].violation(limit.value(spline_.control, r)));
      }
    }
  }

  bool holds() const {
    return places_.violation <= input_.options.constraint_tolerance &&
           rates_.violation <= kRateTolerance;
  }

  /// Larger mu, or more knots, where the violation does not fall; false if there is nothing left to
  /// try. Rates count once the places all but hold: pressed into their limits earlier, they would
  /// lock a curve that still has to find its place.
  bool tighten(double objective) {
    if (rates_.violation > kRateTolerance) {
      if (rates_.mu > 0) {
        if (!rates_.tighten()) return refine_knots();
      } else if (places_.violation <= kFloor) {
        rates_.first_mu = rates_.mu = kRateShare * objective;
      }
    }
    if (places_.violation > input_.options.constraint_tolerance) {
      if (!places_.tighten()) return refine_knots();
    }
    return true;
  }

  Group& group_of(const LimitConstraint& limit) { return limit.derivative == 0 ? places_ : rates_; }

  /// Those of constraints that could not be met are large and mean nothing.
  void forget_multipliers() {
    for (PointConstraint& point : points_) {
      for (PointConstraint::Row& row : point.rows) row.bounds.multiplier = 0;
    }
  }

  void update_multipliers() {
    for (std::size_t i = 0; i < points_.size(); ++i) {
      for (std::size_t r = 0; r < points_[i].rows.size(); ++r) {
        points_[i].rows[r].bounds.update_multiplier(values_[i].c[static_cast<Eigen::Index>(r)],
                                                    places_.mu);
      }
    }
    for (LimitConstraint& limit : limits_) {
      const double mu = group_of(limit).mu;
      for (std::size_t r = 0; mu > 0 && r < limit.rows.size(); ++r) {
        limit.rows[r].update_multiplier(limit.value(spline_.control, r), mu);
      }
    }
  }

  /// Adds a constraint point at the worst dip of every interval that has one.
  bool add_dips() {
    const double half = 0.5 * input_.options.clearance_epsilon;
    const auto dips = find_dips(input_.task, spline_, checker_, required_ - half, half);
    for (const Dip& dip : dips) {
      points_.push_back(
          constraint_between(input_.task, dip.interval, dip.time, kBetweenShare, spline_.basis));
    }
    return !dips.empty();
  }

  ObjectiveTerms terms() const {
    return objective_terms(weights_, input_.robot, input_.task, spline_);
  }

  Refined finish(bool feasible, const std::string& termination) {
    const ObjectiveTerms final_terms = terms();
    statistics_.run = true;
    statistics_.rounds = std::min(round_ + 1, input_.options.max_rounds);
    statistics_.control_points = spline_.basis.control_count();
    statistics_.constraint_points = static_cast<int>(points_.size());
    statistics_.max_violation = places_.violation;
    statistics_.termination = termination;
    statistics_.objective = final_terms.total();
    statistics_.terms = {{"joint_motion", initial_.joint_motion, final_terms.joint_motion},
                         {"acceleration", initial_.acceleration, final_terms.acceleration},
                         {"jerk", initial_.jerk, final_terms.jerk},
                         {"euler", initial_.euler, final_terms.euler}};
    std::vector<double> times;
    for (const Waypoint& waypoint : input_.task.waypoints) times.push_back(waypoint.time);
    return {spline_.sampled_at(times), feasible, statistics_};
  }

  const RefinementInput& input_;
  ObjectiveWeights weights_;
  ClearanceChecker checker_;
  double required_;
  double spacing_;
  Spline spline_;
  ObjectiveTerms initial_;
  Group places_;  ///< constraints in m and rad
  Group rates_;   ///< shares of velocity, acceleration and jerk limits
  int round_ = 0;
  std::vector<PointConstraint> points_;
  std::vector<LimitConstraint> limits_;
  std::vector<SpanFactor> span_factors_;
  std::vector<EulerPoint> euler_points_;
  std::vector<PointValues> values_;
  RefineStatistics statistics_;
};

bool is_better(const Refined& a, const Refined& b) {
  if (a.feasible != b.feasible) return a.feasible;
  return a.feasible ? a.statistics.objective < b.statistics.objective
                    : a.statistics.max_violation < b.statistics.max_violation;
}

double initial_objective(const Refined& refined) {
  double sum = 0;
  for (const CostTerm& term : refined.statistics.terms) sum += term.initial;
  return sum;
}

}  // namespace

Refined refine(const RefinementInput& input, const JointPath& seed) {
  Refined best;
  int iterations = 0, evaluations = 0, rounds = 0;
  for (const double share : kStartShares) {
    Refined attempt = Attempt(input, seed, share).run();
    iterations += attempt.statistics.iterations;
    evaluations += attempt.statistics.evaluations;
    rounds += attempt.statistics.rounds;
    if (best.trajectory.empty() || is_better(attempt, best)) best = std::move(attempt);
    if (best.feasible && best.statistics.objective <= initial_objective(best)) break;
  }
  best.statistics.iterations = iterations;
  best.statistics.evaluations = evaluations;
  best.statistics.rounds = rounds;
  return best;
}

}  // namespace wristwise
