#include "refine/augmented_row.hpp"

#include <gtest/gtest.h>

#include <random>

namespace wristwise {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Case {
  double lower, upper;
};
const std::vector<Case> kCases = {{0.3, 0.3}, {-1, 2}, {0.5, kInfinity}, {-kInfinity, 0.5}};

/// mu / 2 dist(c + lambda / mu, [lower, upper])^2, by trying every point of the interval.
double penalty(const AugmentedRow& row, double c, double mu) {
  const double s = c + row.multiplier / mu;
  const double from = std::max(row.lower, -50.0), to = std::min(row.upper, 50.0);
  double least = kInfinity;
  for (int i = 0; i <= 200000; ++i) {
    least = std::min(least, std::abs(s - (from + (to - from) * i / 200000)));
  }
  return 0.5 * mu * least * least;
}

TEST(AugmentedRow, ResidualIsTheScaledDistanceFromTheBounds) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> value(-3, 3);
  for (const Case& bounds : kCases) {
    for (int i = 0; i < 20; ++i) {
      const AugmentedRow row{bounds.lower, bounds.upper, value(random)};
      const double c = value(random), mu = std::exp(value(random));
      double slope = 0;
      const double residual = row.residual(c, mu, slope);
      EXPECT_NEAR(0.5 * residual * residual, penalty(row, c, mu), 1e-3 * mu);
      double unused = 0;
      const double h = 1e-7;
      const double numeric =
          (row.residual(c + h, mu, unused) - row.residual(c - h, mu, unused)) / (2 * h);
      EXPECT_NEAR(slope, numeric, 1e-6);
    }
  }
}

TEST(AugmentedRow, ViolationIsWhatIsOutside) {
  EXPECT_EQ((AugmentedRow{0, 1, 9}.violation(-0.25)), 0.25);
  EXPECT_EQ((AugmentedRow{0, 1, 9}.violation(1.5)), 0.5);
  EXPECT_EQ((AugmentedRow{0, 1, 9}.violation(0.5)), 0);
  EXPECT_EQ((AugmentedRow{0, kInfinity, 9}.violation(1e9)), 0);
  EXPECT_EQ((AugmentedRow{-kInfinity, 0, 9}.violation(-1e9)), 0);
}

TEST(AugmentedRow, EqualityHasASlopeAtItsSolution) {
  double slope = 0;
  EXPECT_EQ((AugmentedRow{2, 2, 0}.residual(2, 9, slope)), 0);
  EXPECT_EQ(slope, 3);
}

TEST(AugmentedRow, IsSlackAboveMeansNoResidualFromThereOn) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> value(-3, 3);
  int slack = 0;
  for (int i = 0; i < 1000; ++i) {
    const AugmentedRow row{0.5, kInfinity, value(random)};
    const double c = value(random), mu = std::exp(value(random));
    double slope = 0;
    const bool silent = row.residual(c, mu, slope) == 0;
    EXPECT_EQ(row.is_slack_above(c, mu), silent);
    if (!silent) continue;
    ++slack;
    for (double more = 0; more < 5; more += 0.1) EXPECT_EQ(row.residual(c + more, mu, slope), 0);
  }
  EXPECT_GT(slack, 100);
  EXPECT_LT(slack, 900);
  EXPECT_FALSE((AugmentedRow{-1, 1, 0}.is_slack_above(0, 1)));
}

/// min (x - target)^2 / 2 in bounds, x1 = argmin of the augmented Lagrangian in closed form: the
/// iteration must find the bound and the multiplier target - bound of the solution.
TEST(AugmentedRow, MultipliersConvergeToTheSolutionOfAQuadraticProgramme) {
  for (const double target : {-4.0, 0.4, 7.0}) {
    for (const Case& bounds : kCases) {
      AugmentedRow row{bounds.lower, bounds.upper, 0};
      const double mu = 2, solution = std::clamp(target, bounds.lower, bounds.upper);
      double x = 0;
      for (int round = 0; round < 60; ++round) {
        // Outside the bounds (x - target) + mu (x + lambda / mu - bound) = 0, inside x = target.
        x = target;
        for (const double bound : {bounds.lower, bounds.upper}) {
          if (std::isinf(bound)) continue;
          const double candidate = (target + mu * bound - row.multiplier) / (1 + mu);
          double slope = 0;
          const double residual = row.residual(candidate, mu, slope);
          if (std::abs(candidate - target + slope * residual) < 1e-12) x = candidate;
        }
        row.update_multiplier(x, mu);
      }
      EXPECT_NEAR(x, solution, 1e-9);
      EXPECT_NEAR(row.multiplier, target - solution, 1e-9);
    }
  }
}

}  // namespace
}  // namespace wristwise
