#include "timing/motion_rates.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace wristwise {
namespace {

/// q = (sin 3 tau, tau^3) and its derivatives.
Rates motion_rates(double tau) {
  Rates rates(2, 3);
  rates << 3 * std::cos(3 * tau), -9 * std::sin(3 * tau), -27 * std::cos(3 * tau),  //
      3 * tau * tau, 6 * tau, 6;
  return rates;
}

// (F26), against the chain rule worked out by hand for tau = t^2 / 2: sin(1.5 t^2), t^6 / 8.
TEST(MotionRates, AlongALawAreTheDerivativesOfTheComposition) {
  for (const double t : {0.0, 0.3, 1.0, 2.2}) {
    const Rates along = along_law(motion_rates(0.5 * t * t), {t, 1, 0});
    const double s = std::sin(1.5 * t * t), c = std::cos(1.5 * t * t);
    EXPECT_NEAR(along(0, 0), 3 * t * c, 1e-12);
    EXPECT_NEAR(along(0, 1), 3 * c - 9 * t * t * s, 1e-12);
    EXPECT_NEAR(along(0, 2), -27 * t * s - 27 * t * t * t * c, 1e-11);
    EXPECT_NEAR(along(1, 0), 0.75 * std::pow(t, 5), 1e-11);
    EXPECT_NEAR(along(1, 1), 3.75 * std::pow(t, 4), 1e-11);
    EXPECT_NEAR(along(1, 2), 15 * std::pow(t, 3), 1e-11);
  }
}

Trajectory one_joint(std::vector<double> t, std::vector<double> q, std::vector<double> v,
                     std::vector<double> a) {
  const auto vectors = [](const std::vector<double>& values) {
    std::vector<JointVector> list;
    for (const double value : values) list.push_back(JointVector::Constant(1, value));
    return list;
  };
  return {std::move(t), vectors(q), vectors(v), vectors(a)};
}

TEST(MotionRates, AMotionRunAlongALawPassesTheSamePostures) {
  const Trajectory outer = one_joint({0, 2}, {1, 3}, {0.5, -1}, {0.2, 0.1});
  const Trajectory inner = one_joint({5, 6, 9}, {0, 1, 2}, {0.2, 0.6, 0}, {0.3, 0, 0});
  const Trajectory both = run_along(outer, inner);
  for (const double t : inner.times()) {
    const auto composed = [&](double time) { return outer.evaluate(inner.evaluate(time)[0])[0]; };
    constexpr double h = 1e-4;
    const double x = std::min(std::max(t, 5 + h), 9 - h);
    EXPECT_NEAR(both.evaluate(t)[0], composed(t), 1e-14);
    EXPECT_NEAR(both.evaluate(x, 1)[0], (composed(x + h) - composed(x - h)) / (2 * h), 1e-3);
    EXPECT_NEAR(both.evaluate(x, 2)[0],
                (composed(x + h) - 2 * composed(x) + composed(x - h)) / (h * h), 1e-2);
  }
}

}  // namespace
}  // namespace wristwise
