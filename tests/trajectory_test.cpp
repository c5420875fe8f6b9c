#include "wristwise/trajectory.hpp"

#include "task/motion_piece.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "task/polynomial.hpp"
#include "wristwise/error.hpp"

namespace wristwise {
namespace {

JointVector vector(std::initializer_list<double> values) {
  JointVector v(static_cast<Eigen::Index>(values.size()));
  std::copy(values.begin(), values.end(), v.data());
  return v;
}

/// A quintic and a sine, sampled with their true derivatives.
Trajectory sampled(const std::vector<double>& times) {
  std::vector<JointVector> q, v, a;
  for (const double t : times) {
    q.push_back(vector({std::pow(t, 5) - 2 * t * t, std::sin(t)}));
    v.push_back(vector({5 * std::pow(t, 4) - 4 * t, std::cos(t)}));
    a.push_back(vector({20 * std::pow(t, 3) - 4, -std::sin(t)}));
  }
  return {times, q, v, a};
}

Trajectory random_trajectory(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> value(-1, 1), step(0.1, 2);
  std::vector<double> times = {value(random)};
  std::vector<JointVector> q, v, a;
  for (int i = 0; i < 5; ++i) {
    if (i > 0) times.push_back(times.back() + step(random));
    q.push_back(vector({value(random), value(random)}));
    v.push_back(vector({value(random), value(random)}));
    a.push_back(vector({value(random), value(random)}));
  }
  return {times, q, v, a};
}

TEST(Trajectory, ReproducesAQuinticAndItsDerivatives) {
  const Trajectory trajectory = sampled({0, 0.7, 1.0, 2.5});
  for (double t = 0; t <= 2.5; t += 0.01) {
    EXPECT_NEAR(trajectory.evaluate(t)[0], std::pow(t, 5) - 2 * t * t, 1e-11);
    EXPECT_NEAR(trajectory.evaluate(t, 1)[0], 5 * std::pow(t, 4) - 4 * t, 1e-10);
    EXPECT_NEAR(trajectory.evaluate(t, 2)[0], 20 * std::pow(t, 3) - 4, 1e-9);
    EXPECT_NEAR(trajectory.evaluate(t, 3)[0], 60 * t * t, 1e-8);
    EXPECT_NEAR(trajectory.evaluate(t)[1], std::sin(t), 1e-3);
  }
}

TEST(Trajectory, IsHeldOutsideItsTimes) {
  const Trajectory trajectory = sampled({0, 1, 2});
  EXPECT_EQ(trajectory.evaluate(-5), trajectory.evaluate(0));
  EXPECT_EQ(trajectory.evaluate(7), trajectory.evaluate(2));
}

TEST(Trajectory, ExtremesAreThoseOfADenseSampling) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    const Trajectory trajectory = random_trajectory(seed);
    for (std::size_t piece = 0; piece + 1 < trajectory.times().size(); ++piece) {
      const double t0 = trajectory.times()[piece], t1 = trajectory.times()[piece + 1];
      for (int derivative = 0; derivative <= 3; ++derivative) {
        JointVector least, largest;
        trajectory.extremes(piece, derivative, least, largest);
        JointVector low = trajectory.evaluate(t0, derivative), high = low;
        for (int k = 0; k < 2000; ++k) {
          const JointVector value = trajectory.evaluate(t0 + k * (t1 - t0) / 2000, derivative);
          low = low.cwiseMin(value);
          high = high.cwiseMax(value);
        }
        const double scale = 1 + high.cwiseAbs().maxCoeff() + low.cwiseAbs().maxCoeff();
        EXPECT_TRUE(((low - least).array() >= -1e-9 * scale).all());
        EXPECT_TRUE(((largest - high).array() >= -1e-9 * scale).all());
        EXPECT_LT((low - least).maxCoeff(), 5e-3 * scale);
        EXPECT_LT((largest - high).maxCoeff(), 5e-3 * scale);
      }
    }
  }
}

TEST(Trajectory, StaysWithinItsSpread) {
  for (unsigned seed = 0; seed < 30; ++seed) {
    const Trajectory trajectory = random_trajectory(seed);
    const double t0 = trajectory.times()[1], t1 = trajectory.times()[2];
    for (const auto& [a, b] : {std::pair{0.0, 1.0}, {0.3, 0.5}, {0.9, 0.91}}) {
      const double from = t0 + a * (t1 - t0), to = t0 + b * (t1 - t0);
      const MotionPiece piece(t0, t1, trajectory.polynomials(1));
      const JointVector bound = spread(piece.over(from, to));
      const JointVector middle = trajectory.evaluate(0.5 * (from + to));
      double tightest = 0;
      for (int k = 0; k <= 200; ++k) {
        const JointVector away =
            (trajectory.evaluate(from + k * (to - from) / 200) - middle).cwiseAbs();
        EXPECT_TRUE(((bound - away).array() >= -1e-12).all());
        tightest = std::max(tightest, away.cwiseQuotient(bound).maxCoeff());
      }
      if (b - a < 0.1) {
        EXPECT_GT(tightest, 0.9);
      }
    }
  }
}

/// A piece, and a part of it, in powers of their own s.
TEST(Trajectory, PiecesAreTheSamePolynomials) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Trajectory trajectory = random_trajectory(seed);
    const double t0 = trajectory.times()[1], t1 = trajectory.times()[2];
    const MotionPiece piece(t0, t1, trajectory.polynomials(1));
    for (const auto& [a, b] : {std::pair{0.0, 1.0}, {0.2, 0.25}, {0.9, 1.0}}) {
      const double from = t0 + a * (t1 - t0), to = t0 + b * (t1 - t0);
      const auto part = piece.over(from, to);
      for (const double share : {0.0, 0.3, 0.5, 1.0}) {
        const double t = from + share * (to - from), s = 2 * share - 1;
        JointVector value = part.col(5);
        for (int k = 4; k >= 0; --k) value = value * s + part.col(k);
        EXPECT_LT((value - trajectory.evaluate(t)).cwiseAbs().maxCoeff(), 1e-12);
        EXPECT_LT((piece.posture(t) - trajectory.evaluate(t)).cwiseAbs().maxCoeff(), 1e-12);
      }
    }
  }
}

TEST(Trajectory, RefusesWhatIsNoCurve) {
  const JointVector q = vector({0.0});
  const JointVector nan = vector({std::nan("")});
  EXPECT_THROW(Trajectory({0}, {q}, {q}, {q}), InvalidInput);
  EXPECT_THROW(Trajectory({0, 0}, {q, q}, {q, q}, {q, q}), InvalidInput);
  EXPECT_THROW(Trajectory({0, INFINITY}, {q, q}, {q, q}, {q, q}), InvalidInput);
  EXPECT_THROW(Trajectory({0, 1}, {q, q}, {q}, {q, q}), InvalidInput);
  EXPECT_THROW(Trajectory({0, 1}, {q, nan}, {q, q}, {q, q}), InvalidInput);
  EXPECT_THROW(Trajectory({0, 1}, {q, vector({0, 1})}, {q, q}, {q, q}), InvalidInput);
}

TEST(ValidatePath, NamesWhatIsWrong) {
  const JointVector q = vector({0.0});
  EXPECT_NO_THROW(validate({{0, 1}, {q, q}}, 1, "path"));
  EXPECT_THROW(validate({{0}, {q}}, 1, "path"), InvalidInput);
  EXPECT_THROW(validate({{}, {}}, 1, "path"), InvalidInput);
  EXPECT_THROW(validate({{0, 1}, {q, q}}, 2, "path"), InvalidInput);
  EXPECT_THROW(validate({{0, 1}, {q, vector({INFINITY})}}, 1, "path"), InvalidInput);
  EXPECT_THROW(validate({{1, 0}, {q, q}}, 1, "path"), InvalidInput);
}

TEST(DividedDifferences, AreExactForPolynomialsOnUnevenTimes) {
  JointPath path;
  for (const double t : {0.0, 0.3, 1.0, 1.1, 2.7, 3.0}) {
    path.times.push_back(t);
    path.positions.push_back(vector({2 * t * t * t - t, 3 * t * t, 5 * t}));
  }
  for (const JointVector& d : divided_differences(path, 3)) {
    EXPECT_LT((d - vector({12, 0, 0})).norm(), 1e-9);
  }
  for (const JointVector& d : divided_differences(path, 2)) EXPECT_NEAR(d[1], 6, 1e-10);
  EXPECT_EQ(divided_differences(path, 1).size(), 5U);
  path.times.resize(2);
  path.positions.resize(2);
  EXPECT_TRUE(divided_differences(path, 3).empty());
}

TEST(Polynomial, FindsExtremesInsideTheInterval) {
  const Polynomial p = {0, 1, -4, 4, 0, 0};  // u (1 - 2u)^2: maximum 2/27 at 1/6, end value 1
  const auto [least, largest] = extremes_on_unit_interval(p);
  EXPECT_NEAR(least, 0, 1e-15);
  EXPECT_NEAR(largest, 1, 1e-15);
  const auto [low, high] = extremes_on_unit_interval({0, -1, 1, 0, 0, 0});
  EXPECT_NEAR(low, -0.25, 1e-15);
  EXPECT_EQ(high, 0);
}

}  // namespace
}  // namespace wristwise
