#include "refine/augmented_lagrangian.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "refine/spline_solver.hpp"

namespace wristwise {

namespace {

constexpr double kGrowth = 10;       ///< of mu in a round that gains too little
constexpr double kMuRange = 1e12;    ///< largest mu / first mu
constexpr double kFloor = 1e-4;      ///< m and rad; places all but hold below this
constexpr double kInVain = 0.9;      ///< of a violation: what a larger mu that helps can't leave
constexpr double kSoftening = 1e-3;  ///< of mu after a violation that did not give way
constexpr double kRateShare = 0.1;   ///< first mu of rates, as a share of the objective
constexpr double kRateTolerance = 5e-4;  ///< of rates, half the margin they are kept by
constexpr double kBand = 0.02;           ///< m; pairs that are nearer than this get a constraint
constexpr double kMoves = 0.05;          ///< relative change of the objective that counts
constexpr int kPatience = 1;  ///< rounds in which the inner solver may run out of iterations

}  // namespace

void AugmentedLagrangian::Group::raise(double value) { violation = std::max(violation, value); }

/// After a round that left a violation: larger mu where it gained too little, the more the less it
/// gained. False where nothing has moved for `patience` rounds: neither the violation nor, as
/// `moves` says, the objective, which rises as long as constraints are bought.
bool AugmentedLagrangian::Group::tighten(int patience, bool moves) {
  const bool gains_little = violation > 0.5 * best_violation;
  stalled = gains_little && !moves ? stalled + 1 : 0;
  if (mu >= kMuRange * first_mu || stalled >= patience) return false;
  if (!gains_little) useful_mu = mu;
  if (violation > 0.1 * best_violation) mu *= gains_little ? kGrowth * kGrowth : kGrowth;
  best_violation = std::min(best_violation, violation);
  return true;
}

bool AugmentedLagrangian::Group::grew_in_vain() const {
  return mu > useful_mu && violation > kInVain * best_violation;
}

void AugmentedLagrangian::Group::restart() {
  best_violation = std::numeric_limits<double>::infinity();
  stalled = 0;
  useful_mu = mu;
}

AugmentedLagrangian::AugmentedLagrangian(const RefinementInput& input,
                                         const ObjectiveWeights& weights, ClearanceChecker& checker,
                                         Spline start, double first_mu)
    : input_(input),
      weights_(weights),
      checker_(checker),
      required_(input.clearance->clearance() + input.options.clearance_epsilon),
      spline_(std::move(start)) {
  places_.first_mu = places_.mu = first_mu;
  restart();
  use_breakpoints(spline_.basis.breakpoints());
}

void AugmentedLagrangian::restart() {
  places_.restart();
  rates_.restart();
}

void AugmentedLagrangian::soften() {
  places_.mu = std::min(places_.useful_mu, std::max(places_.first_mu, kSoftening * places_.mu));
  for (PointConstraint& point : points_) {
    for (PointConstraint::Row& row : point.rows) row.bounds.multiplier = 0;
  }
}

void AugmentedLagrangian::soften(const std::vector<double>& at) {
  places_.mu = places_.useful_mu;
  const auto& breakpoints = spline_.basis.breakpoints();
  for (PointConstraint& point : points_) {
    const auto end = std::upper_bound(breakpoints.begin() + 1, breakpoints.end() - 1, point.time);
    const auto violated = std::lower_bound(at.begin(), at.end(), *(end - 1));
    if (violated == at.end() || *violated > *end) continue;
    for (PointConstraint::Row& row : point.rows) row.bounds.multiplier = 0;
  }
}

void AugmentedLagrangian::add_points(const std::vector<PointConstraint>& points) {
  points_.insert(points_.end(), points.begin(), points.end());
  restart();
}

AugmentedLagrangian::State AugmentedLagrangian::state() const {
  return {spline_, places_, rates_, points_, limits_};
}

void AugmentedLagrangian::restore(State state) {
  std::vector<double> breakpoints = state.spline.basis.breakpoints();
  spline_ = std::move(state.spline);
  points_ = std::move(state.points);
  use_breakpoints(std::move(breakpoints));
  limits_ = std::move(state.limits);
  places_ = state.places;
  rates_ = state.rates;
}

void AugmentedLagrangian::relax() { places_.mu = std::max(places_.first_mu, places_.mu / kGrowth); }

void AugmentedLagrangian::use_breakpoints(std::vector<double> breakpoints) {
  if (breakpoints.size() != spline_.basis.breakpoints().size())
    spline_ = with_breakpoints(spline_, std::move(breakpoints));
  objective_rows_ = objective_rows(weights_, spline_.basis);
  deviation_points_ = deviation_points(weights_, input_.task, spline_.basis);
  singularity_points_ = singularity_points(weights_, spline_.basis);
  own_points_ = own_points(weights_, spline_.basis);
  limits_ = limit_constraints(input_.robot, spline_.basis);
  for (PointConstraint& point : points_) point.basis = spline_.basis.at(point.time);
  if (places_.mu > kGrowth * kGrowth * places_.useful_mu)
    places_.mu = std::max(places_.first_mu, places_.useful_mu);  // the old knots could not follow
  rates_.mu = rates_.first_mu;  // the multipliers of the limits are lost
  restart();
}

Ending AugmentedLagrangian::solve(const Accuracy& accuracy, const Stop& stop,
                                  const std::function<void()>& when_holding) {
  double last_objective = std::numeric_limits<double>::infinity();
  int unsettled = 0;
  for (int round = 0; round < accuracy.rounds; ++round) {
    input_.monitor.report("refine",
                          std::min(1.0, static_cast<double>(rounds_) / input_.options.max_rounds));
    if (stop.requested()) return Ending::stopped;
    ++rounds_;
    add_near_pairs_everywhere();
    const bool settled_inside = minimise_once(accuracy.inner, stop);
    if (stop.requested()) return Ending::stopped;
    measure();
    const double objective = terms().total();
    const bool settled =
        settled_inside && std::abs(objective - last_objective) <= accuracy.settled * objective;
    const bool moves = std::abs(objective - last_objective) > kMoves * objective;
    last_objective = objective;
    if (!accuracy.rates) rates_.violation = 0;
    const bool holds = places_.violation <= accuracy.violation && rates_hold();
    update_multipliers();
    if (holds && settled) return Ending::converged;
    if (holds && when_holding) when_holding();
    unsettled = settled_inside ? 0 : unsettled + 1;
    const bool is_due = settled_inside || unsettled > kPatience;
    if (is_due && !tighten(accuracy, objective, moves)) return Ending::stalled;
  }
  return Ending::out_of_rounds;
}

void AugmentedLagrangian::start_near(double stray, const Accuracy& accuracy, const Stop& stop) {
  const Spline start = spline_;
  for (int attempt = 0; attempt < 6; ++attempt) {
    add_near_pairs_everywhere();
    minimise_once(accuracy.inner, stop);
    add_near_pairs_everywhere();  // the path may have gone into what the seed was far from
    measure();
    if (places_.violation <= stray || stop.requested()) break;
    spline_ = start;
    places_.first_mu = places_.mu *= kGrowth;
  }
  update_multipliers();
}

void AugmentedLagrangian::add_near_pairs_everywhere() {
  for (PointConstraint& point : points_) {
    add_near_pairs(point, checker_, spline_.evaluate(point.time), required_, kBand);
  }
}

bool AugmentedLagrangian::minimise_once(double function_tolerance, const Stop& stop) {
  const AugmentedProblem problem{input_.robot,
                                 checker_,
                                 weights_,
                                 objective_rows_,
                                 deviation_points_,
                                 singularity_points_,
                                 own_points_,
                                 points_,
                                 limits_,
                                 places_.mu,
                                 rates_.mu,
                                 input_.task.rest_at_start,
                                 input_.task.rest_at_end};
  InnerOptions options;
  options.max_iterations = input_.options.max_iterations;
  options.function_tolerance = function_tolerance;
  options.trust_region = trust_region_;
  const InnerSummary inner = minimise(problem, spline_, options, stop);
  iterations_ += inner.iterations;
  evaluations_ += inner.evaluations;
  trust_region_ = inner.trust_region;
  return inner.converged;
}

/// Finds the largest violations; keeps the values for the update of the multipliers.
void AugmentedLagrangian::measure() {
  places_.violation = rates_.violation = 0;
  values_.resize(points_.size());
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const PointConstraint& point = points_[i];
    evaluate(point, checker_, spline_.evaluate(point.time), places_.mu * point.weight, false,
             values_[i]);
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

bool AugmentedLagrangian::rates_hold() const { return rates_.violation <= kRateTolerance; }

/// Larger mu where the violation does not fall; false if that does not help any more. Rates count
/// once the places all but hold: pressed into their limits earlier, they would lock a curve that
/// still has to find its place.
bool AugmentedLagrangian::tighten(const Accuracy& accuracy, double objective, bool moves) {
  if (!rates_hold()) {
    if (rates_.mu > 0) {
      if (!rates_.tighten(accuracy.patience, moves)) return false;
    } else if (places_.violation <= kFloor) {
      rates_.first_mu = rates_.mu = kRateShare * objective;
    }
  }
  if (places_.violation <= accuracy.violation) return true;
  const bool all_but_hold = places_.violation <= kFloor;
  if (!accuracy.persistent && (all_but_hold || !moves) && places_.grew_in_vain()) return false;
  return places_.tighten(accuracy.patience, moves && !all_but_hold);
}

void AugmentedLagrangian::update_multipliers() {
  for (std::size_t i = 0; i < points_.size(); ++i) {
    for (std::size_t r = 0; r < points_[i].rows.size(); ++r) {
      points_[i].rows[r].bounds.update_multiplier(values_[i].c[static_cast<Eigen::Index>(r)],
                                                  places_.mu * points_[i].weight);
    }
  }
  for (LimitConstraint& limit : limits_) {
    const double mu = group_of(limit).mu;
    for (std::size_t r = 0; mu > 0 && r < limit.rows.size(); ++r) {
      limit.rows[r].update_multiplier(limit.value(spline_.control, r), mu);
    }
  }
}

std::vector<double> AugmentedLagrangian::violated_times(double tolerance) const {
  std::vector<double> times;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    for (std::size_t r = 0; r < points_[i].rows.size(); ++r) {
      const double c = values_[i].c[static_cast<Eigen::Index>(r)];
      if (points_[i].rows[r].bounds.violation(c) > tolerance) times.push_back(points_[i].time);
    }
  }
  for (const LimitConstraint& limit : limits_) {
    for (std::size_t r = 0; r < limit.rows.size(); ++r) {
      const double allowed = limit.derivative == 0 ? tolerance : kRateTolerance;
      if (limit.rows[r].violation(limit.value(spline_.control, r)) <= allowed) continue;
      const int last = limit.first + static_cast<int>(limit.weights.size()) - 1;
      times.push_back(0.5 * (spline_.basis.knot(limit.first + SplineBasis::kDegree - 2) +
                             spline_.basis.knot(last + 3)));
    }
  }
  std::sort(times.begin(), times.end());
  return times;
}

ObjectiveTerms AugmentedLagrangian::terms() const {
  return objective_terms(weights_, input_.robot, input_.task, spline_);
}

AugmentedLagrangian::Group& AugmentedLagrangian::group_of(const LimitConstraint& limit) {
  return limit.derivative == 0 ? places_ : rates_;
}

}  // namespace wristwise
