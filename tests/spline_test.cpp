#include "refine/spline.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "refine/breakpoints.hpp"
#include "refine/gauss_quadrature.hpp"

namespace wristwise {
namespace {

const std::vector<double> kBreakpoints = {-1, 0, 0.7, 2, 2.2, 3.5};

/// The Cox-de Boor recursion, word for word.
double cox_de_boor(const std::vector<double>& knots, std::size_t i, std::size_t degree, double t) {
  if (degree == 0) return knots[i] <= t && t < knots[i + 1] ? 1 : 0;
  const auto share = [](double above, double below) { return below == 0 ? 0 : above / below; };
  return share(t - knots[i], knots[i + degree] - knots[i]) * cox_de_boor(knots, i, degree - 1, t) +
         share(knots[i + degree + 1] - t, knots[i + degree + 1] - knots[i + 1]) *
             cox_de_boor(knots, i + 1, degree - 1, t);
}

Spline random_spline(unsigned seed, std::vector<double> breakpoints = kBreakpoints) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  Spline spline{SplineBasis(std::move(breakpoints)), {}};
  spline.control =
      Eigen::MatrixXd::NullaryExpr(2, spline.basis.control_count(), [&] { return normal(random); });
  return spline;
}

TEST(SplineBasis, FollowsTheCoxDeBoorRecursion) {
  const SplineBasis basis(kBreakpoints);
  std::vector<double> knots(5, -1.0);
  knots.insert(knots.end(), kBreakpoints.begin(), kBreakpoints.end());
  knots.insert(knots.end(), 5, 3.5);
  for (double t = -1; t < 3.5; t += 0.0317) {
    const SplineBasis::Values values = basis.at(t);
    for (int i = 0; i < basis.control_count(); ++i) {
      const int k = i - values.first;
      const double found = k >= 0 && k < SplineBasis::kLocal ? values.derivatives(k, 0) : 0;
      EXPECT_NEAR(found, cox_de_boor(knots, static_cast<std::size_t>(i), 5, t), 1e-13);
    }
  }
}

TEST(SplineBasis, DerivativesEqualNumericDifferences) {
  const Spline spline = random_spline(1);
  const double h = 1e-5;
  for (double t = -0.99; t < 3.49; t += 0.0317) {
    for (int k = 0; k < 3; ++k) {
      const JointVector numeric = (spline.evaluate(t + h, k) - spline.evaluate(t - h, k)) / (2 * h);
      const JointVector exact = spline.evaluate(t, k + 1);
      EXPECT_LT((numeric - exact).norm(), 1e-3 * (1 + exact.norm())) << t << " " << k;
    }
  }
}

TEST(SplineBasis, ControlPointsOfDerivativesHoldTheDerivativeInTheirHull) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Spline spline = random_spline(seed);
    for (int k = 1; k <= 3; ++k) {
      Eigen::VectorXd lower = Eigen::VectorXd::Constant(2, INFINITY), upper = -lower;
      for (int i = 0; i + k < spline.basis.control_count(); ++i) {
        Eigen::VectorXd point = Eigen::VectorXd::Zero(2);
        const auto weights = spline.basis.derivative_weights(k, i);
        for (int m = 0; m <= k; ++m) {
          point += weights[static_cast<std::size_t>(m)] * spline.control.col(i + m);
        }
        lower = lower.cwiseMin(point);
        upper = upper.cwiseMax(point);
        // The first and the last control point are the end values themselves.
        if (i > 0) continue;
        EXPECT_LT((point - spline.evaluate(-1, k)).norm(), 1e-9 * (1 + point.norm()));
      }
      for (double t = -1; t <= 3.5; t += 0.01) {
        const JointVector value = spline.evaluate(t, k);
        EXPECT_TRUE((value.array() <= upper.array() + 1e-9).all());
        EXPECT_TRUE((value.array() >= lower.array() - 1e-9).all());
      }
    }
  }
}

TEST(Spline, SampledAtItsBreakpointsIsTheSameCurve) {
  const Spline spline = random_spline(2);
  std::vector<double> times = kBreakpoints;
  times.insert(times.begin() + 1, -0.4);
  const Trajectory trajectory = spline.sampled_at(times);
  for (double t = -1; t <= 3.5; t += 0.013) {
    for (int k = 0; k <= 3; ++k) {
      const JointVector value = spline.evaluate(t, k);
      EXPECT_LT((trajectory.evaluate(t, k) - value).norm(), 1e-9 * (1 + value.norm()));
    }
  }
}

TEST(FitSpline, ReproducesAPolynomial) {
  JointPath path;
  for (int i = 0; i <= 40; ++i) {
    const double t = 0.1 * i;
    path.times.push_back(t);
    path.positions.push_back(JointVector::Constant(1, t * t - 3 * t + 1));
  }
  const Spline spline = fit_spline(path, choose_breakpoints(path.times, 0.5));
  for (double t = 0; t <= 4; t += 0.01) EXPECT_NEAR(spline.evaluate(t)[0], t * t - 3 * t + 1, 1e-6);
}

TEST(FitSpline, CopesWithFewerPointsThanControlPoints) {
  const JointPath path{{0, 1}, {JointVector::Constant(1, 2.0), JointVector::Constant(1, 3.0)}};
  const Spline spline = fit_spline(path, {0, 1});
  EXPECT_NEAR(spline.evaluate(0)[0], 2, 1e-6);
  EXPECT_NEAR(spline.evaluate(1)[0], 3, 1e-6);
  EXPECT_NEAR(spline.evaluate(0.5)[0], 2.5, 1e-3);
}

TEST(WithBreakpoints, KeepsTheCurve) {
  const Spline spline = random_spline(11, {0, 0.4, 1.5, 2, 5});
  const Spline finer =
      with_breakpoints(spline, {0, 0.1, 0.2, 0.4, 0.41, 1.5, 1.7, 2, 2.5, 3, 4.9, 5});
  for (double t = 0; t <= 5; t += 0.01) {
    for (int k = 0; k <= 3; ++k) {
      const double scale = 1 + spline.evaluate(t, k).norm();
      EXPECT_LT((finer.evaluate(t, k) - spline.evaluate(t, k)).norm(), 1e-9 * scale) << t;
    }
  }
}

TEST(GaussPoints, IntegratePolynomialsOfDegreeNine) {
  double sum = 0;
  for (const QuadraturePoint& point : gauss_points({0, 0.5, 2})) {
    sum += point.weight * std::pow(point.time, 9);
  }
  EXPECT_NEAR(sum, std::pow(2.0, 10) / 10, 1e-10);
}

}  // namespace
}  // namespace wristwise
