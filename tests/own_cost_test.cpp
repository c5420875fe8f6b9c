// Costs of the caller's own: stage 2 with residuals whose optimum is known in closed form.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "invalid_input.hpp"
#include "refinement_example.hpp"
#include "three_point_optimum.hpp"
#include "wristwise/error.hpp"

namespace wristwise {
namespace {

namespace gantry = test::gantry;
using test::Example;
using test::invalid_input;
using test::kDuration;
using test::kTau;
using test::says;
using test::ThreePointOptimum;

const JointVector kPreferred = gantry::posture(0.4, 0.5, -0.5, 0.2);

/// (q_j - p_j) / tau: what a preferred posture is, written as a cost of the caller's.
PostureResidual towards(int joint) {
  return [joint](double, const JointVector& q, JointVector* gradient) {
    if (gradient != nullptr) *gradient = JointVector::Unit(4, joint) / kTau;
    return (q[joint] - kPreferred[joint]) / kTau;
  };
}

TEST(OwnCost, PullsAsMuchAsTheClosedFormSays) {
  Example example(gantry::parts(), test::three_point_task());
  for (int j = 0; j < 4; ++j) example.cost.posture_residuals.push_back(towards(j));
  const Refined refined = example.run(test::three_point_seed(example.task));
  EXPECT_TRUE(refined.feasible) << refined.statistics.termination;
  ThreePointOptimum optimum(4, kDuration, kTau, {false, false, true});
  const double middle[] = {0.7, 0.3, -0.2, 0.1}, end[] = {1, -0.1, 0, 0};
  double objective = 0;
  for (int j = 0; j < 4; ++j) {
    const double at = kPreferred[j];
    optimum.pass_through(0 - at, middle[j] - at, end[j] - at);
    objective += optimum.objective();
    for (int i = 0; i <= 10; ++i) {
      const double t = kDuration * i / 10;
      EXPECT_NEAR(refined.trajectory.evaluate(t)[j], at + optimum.value(t), 1e-4) << t;
    }
  }
  EXPECT_NEAR(refined.statistics.objective, objective, 1e-4 * objective);
  const CostTerm& term = refined.statistics.terms.back();
  EXPECT_EQ(term.name, "own");
  EXPECT_GT(term.final, 0);
  EXPECT_LT(term.final, refined.statistics.objective);
}

TEST(OwnCost, IsNoTermWhereThereIsNone) {
  Example example(gantry::parts(), test::three_point_task());
  const Refined refined = example.run(test::three_point_seed(example.task));
  for (const CostTerm& term : refined.statistics.terms) EXPECT_NE(term.name, "own");
}

std::string complaint(const PostureResidual& residual) {
  Example example(gantry::parts(), test::three_point_task());
  example.cost.posture_residuals = {residual};
  return invalid_input([&] { example.run(test::three_point_seed(example.task)); });
}

/// Also where it shows up in the middle of the solver.
TEST(OwnCost, MustBeFiniteAndFitTheRobot) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(says(complaint([&](double, const JointVector&, JointVector*) { return nan; }),
                   "cost.posture_residuals at 0"));
  const auto with_gradient = [](const JointVector& slope) {
    return complaint([slope](double, const JointVector& q, JointVector* gradient) {
      if (gradient != nullptr) *gradient = slope;
      return q[0];
    });
  };
  EXPECT_TRUE(says(with_gradient(JointVector::Zero(3)), "a gradient of 3 values; expected one"));
  EXPECT_TRUE(says(with_gradient(JointVector::Constant(4, nan)), "gradient that is not finite"));
}

}  // namespace
}  // namespace wristwise
