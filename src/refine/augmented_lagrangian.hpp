#pragma once

#include <functional>
#include <vector>

#include "refine/limit_constraint.hpp"
#include "refine/objective.hpp"
#include "refine/point_constraint.hpp"
#include "refine/refinement.hpp"
#include "refine/stop.hpp"

namespace wristwise {

/// How far a solution is to be carried.
struct Accuracy {
  double violation = 5e-7;  ///< m and rad, of the constraints at their points
  double settled = 1e-4;    ///< relative change of the objective between rounds
  double inner = 1e-8;      ///< relative change of the cost at which the inner solver stops
  int rounds = 30;
  bool rates = true;        ///< velocity, acceleration and jerk limits count
  int patience = 3;         ///< rounds in which the violation may not halve
  bool persistent = false;  ///< a mu that grew in vain is no reason to end
};

enum class Ending {
  converged,
  stalled,  ///< the violation does not fall any more: the curve has too few knots, or no way
  out_of_rounds,
  stopped,  ///< on request
};

/// The augmented Lagrangian (F16) of a curve, its constraint points and its limits.
class AugmentedLagrangian {
 public:
  AugmentedLagrangian(const RefinementInput& input, const ObjectiveWeights& weights,
                      ClearanceChecker& checker, Spline start, double first_mu);
  void set_first_mu(double mu) { places_.first_mu = places_.mu = mu; }

  /// The first round, at a mu large enough that nothing is violated by more than `stray` (m, rad).
  void start_near(double stray, const Accuracy& accuracy, const Stop& stop);

  /// Rounds of inner minimisation and multiplier updates, until the accuracy is reached.
  /// @param when_holding called after each round but the last in which everything holds
  Ending solve(const Accuracy& accuracy, const Stop& stop,
               const std::function<void()>& when_holding = {});

  /// The same curve over more breakpoints, the same points; limits start anew.
  void use_breakpoints(std::vector<double> breakpoints);

  double mu() const { return places_.mu; }
  const Spline& spline() const { return spline_; }
  std::vector<PointConstraint>& points() { return points_; }
  const std::vector<LimitConstraint>& limits() const { return limits_; }
  /// After constraints that could not be met: their multipliers are large and mean nothing.
  void soften();
  /// The same where only the spans that hold one of the times `at` (s, ascending) could not follow:
  /// back to the last mu that helped, and their multipliers start anew.
  void soften(const std::vector<double>& at);
  /// Takes mu a step back; the multipliers stay. Rows that are outside at first are the harder to
  /// minimise over, the stiffer they are.
  void relax();
  void add_points(const std::vector<PointConstraint>& points);
  /// Points were added or exchanged: what was reached so far says nothing about these.
  void restart();

  /// What more breakpoints may spoil, and the way back to it.
  struct State;
  State state() const;
  void restore(State state);

  ObjectiveTerms terms() const;
  double violation() const { return places_.violation; }      ///< m, rad
  double rate_violation() const { return rates_.violation; }  ///< shares of the limits
  /// Times (s) of the points and control points that are violated by more than `tolerance`.
  std::vector<double> violated_times(double tolerance) const;

  int rounds() const { return rounds_; }
  int iterations() const { return iterations_; }
  int evaluations() const { return evaluations_; }

 private:
  /// Constraints that share a unit, and so a penalty parameter.
  struct Group {
    double first_mu = 0;
    double mu = 0;
    double violation = 0;  ///< largest, in the last round
    double best_violation = 0;
    int stalled = 0;
    double useful_mu = 0;  ///< of the last round that lowered the violation

    void raise(double value);
    bool tighten(int patience, bool moves);
    bool grew_in_vain() const;
    void restart();
  };

  bool minimise_once(double function_tolerance, const Stop& stop);
  void add_near_pairs_everywhere();
  void measure();
  bool rates_hold() const;
  bool tighten(const Accuracy& accuracy, double objective, bool moves);
  void update_multipliers();
  Group& group_of(const LimitConstraint& limit);

  const RefinementInput& input_;
  const ObjectiveWeights& weights_;
  ClearanceChecker& checker_;
  double required_;  ///< m, clearance
  Spline spline_;
  Group places_;  ///< constraints in m and rad
  Group rates_;   ///< shares of velocity, acceleration and jerk limits
  std::vector<PointConstraint> points_;
  std::vector<LimitConstraint> limits_;
  std::vector<ObjectiveRow> objective_rows_;
  std::vector<DeviationPoint> deviation_points_;
  std::vector<PosturePoint> singularity_points_, own_points_;
  std::vector<PointValues> values_;
  double trust_region_ = 0;  ///< radius at the end of the last round
  int rounds_ = 0, iterations_ = 0, evaluations_ = 0;
};

struct AugmentedLagrangian::State {
  Spline spline;
  Group places, rates;
  std::vector<PointConstraint> points;
  std::vector<LimitConstraint> limits;
};

}  // namespace wristwise
