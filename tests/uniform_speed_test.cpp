#include "timing/uniform_speed.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace wristwise {
namespace {

Trajectory random_motion(std::mt19937& random, int joints, int points) {
  std::uniform_real_distribution<double> step(0.2, 1), value(-1, 1);
  std::vector<double> times = {3};
  std::vector<JointVector> q, v, a;
  for (int i = 0; i < points; ++i) {
    if (i > 0) times.push_back(times.back() + step(random));
    q.emplace_back(JointVector::NullaryExpr(joints, [&] { return value(random); }));
    v.emplace_back(JointVector::NullaryExpr(joints, [&] { return value(random); }));
    a.emplace_back(JointVector::NullaryExpr(joints, [&] { return value(random); }));
  }
  return {times, q, v, a};
}

Rates random_limits(std::mt19937& random, int joints) {
  std::uniform_real_distribution<double> exponent(-1, 2);
  return Rates::NullaryExpr(joints, 3, [&] { return std::pow(10, exponent(random)); });
}

/// Largest |rate| / limit over many times.
double sampled_ratio(const Trajectory& motion, const Rates& limits) {
  double largest = 0;
  const double t0 = motion.times().front(), t1 = motion.times().back();
  for (int i = 0; i < 20000; ++i) {
    const Rates rates = rates_at(motion, t0 + (t1 - t0) * i / 20000);
    largest = std::max(largest, rates.cwiseAbs().cwiseQuotient(limits).maxCoeff());
  }
  return largest;
}

// (F28)
TEST(UniformSpeed, TheLeastSlowdownBringsOneRateToItsLimit) {
  std::mt19937 random(5);
  for (int trial = 0; trial < 20; ++trial) {
    const Trajectory motion = random_motion(random, 3, 5);
    const Rates limits = random_limits(random, 3);
    const UniformSlowdown slowdown = uniform_slowdown(motion, limits);
    const double ratio = sampled_ratio(stretched(motion, slowdown.factor), limits);
    EXPECT_LE(ratio, 1 + 1e-9);
    EXPECT_GE(ratio, 0.99);
    const Rates rates = rates_at(motion, slowdown.time);
    const double there = std::abs(rates(slowdown.joint, slowdown.derivative - 1)) /
                         limits(slowdown.joint, slowdown.derivative - 1);
    EXPECT_NEAR(there, slowdown.ratio, 0.02 * slowdown.ratio);
    EXPECT_NEAR(std::pow(slowdown.ratio, 1.0 / slowdown.derivative), slowdown.factor, 1e-12);
  }
}

TEST(UniformSpeed, AMotionWithoutLimitsNeedsNone) {
  std::mt19937 random(6);
  const Trajectory motion = random_motion(random, 2, 3);
  const UniformSlowdown slowdown = uniform_slowdown(motion, Rates::Constant(2, 3, INFINITY));
  EXPECT_EQ(slowdown.factor, 0);
  EXPECT_EQ(slowdown.joint, -1);
}

TEST(UniformSpeed, StretchingKeepsTheCurve) {
  std::mt19937 random(7);
  const Trajectory motion = random_motion(random, 2, 4), slow = stretched(motion, 2.5);
  for (double t = 3; t < motion.times().back(); t += 0.01) {
    EXPECT_LT((slow.evaluate(3 + 2.5 * (t - 3)) - motion.evaluate(t)).norm(), 1e-12);
  }
}

}  // namespace
}  // namespace wristwise
