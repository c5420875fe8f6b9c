#include "timing/speed_profile.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "timing/uniform_speed.hpp"
#include "wristwise/error.hpp"

namespace wristwise {
namespace {

constexpr double kNone = INFINITY;

/// A constant speed on joint 0; joint 1 turns by pi x size about `middle`, mostly within +-width.
Trajectory flip(int points, double duration, double size, double width, double middle) {
  std::vector<double> times;
  std::vector<JointVector> q, v, a;
  for (int i = 0; i < points; ++i) {
    const double t = 2 + duration * i / (points - 1), s = (t - 2 - middle) / width;
    const double slope = 1 / (1 + s * s);
    times.push_back(t);
    q.emplace_back(Eigen::Vector2d(0.1 * t, size * std::atan(s)));
    v.emplace_back(Eigen::Vector2d(0.1, size * slope / width));
    a.emplace_back(Eigen::Vector2d(0, -2 * size * s * slope * slope / (width * width)));
  }
  return {times, q, v, a};
}

Rates limits(double velocity, double acceleration, double jerk) {
  Rates limits(2, 3);
  limits << velocity, acceleration, jerk, velocity, acceleration, jerk;
  return limits;
}

double nominal(const Trajectory& law, double t) { return law.evaluate(t)[0]; }
double speed(const Trajectory& law, double t) { return law.evaluate(t, 1)[0]; }

double real_time(const Trajectory& law, double tau) {
  double before = law.times().front(), after = law.times().back();
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (before + after);
    (nominal(law, middle) < tau ? before : after) = middle;
  }
  return after;
}

/// From differences of postures alone: nothing of the formulas of the code.
void expect_limits_hold(const Trajectory& motion, const Trajectory& law, const Rates& limits,
                        int samples = 20000) {
  const double t0 = law.times().front(), t1 = law.times().back();
  const double h = (t1 - t0) / samples;
  std::vector<JointVector> q;
  for (int i = 0; i <= samples; ++i) q.push_back(motion.evaluate(nominal(law, t0 + i * h)));
  Rates largest = Rates::Zero(limits.rows(), 3);
  for (std::size_t i = 0; i + 3 < q.size(); ++i) {
    largest.col(0) = largest.col(0).cwiseMax((q[i + 1] - q[i]).cwiseAbs() / h);
    largest.col(1) = largest.col(1).cwiseMax((q[i + 2] - 2 * q[i + 1] + q[i]).cwiseAbs() / (h * h));
    largest.col(2) = largest.col(2).cwiseMax(
        (q[i + 3] - 3 * q[i + 2] + 3 * q[i + 1] - q[i]).cwiseAbs() / (h * h * h));
  }
  const double round_off = 1e-14 / (h * h * h);
  EXPECT_LE(largest.col(0).cwiseQuotient(limits.col(0)).maxCoeff(), 1);
  EXPECT_LE(largest.col(1).cwiseQuotient(limits.col(1)).maxCoeff(), 1);
  EXPECT_LE(((largest.col(2).array() - round_off) / limits.col(2).array()).maxCoeff(), 1);
}

void expect_a_law(const Trajectory& motion, const Trajectory& law) {
  EXPECT_EQ(law.times().front(), motion.times().front());
  EXPECT_EQ(nominal(law, law.times().front()), motion.times().front());
  EXPECT_NEAR(nominal(law, law.times().back()), motion.times().back(), 1e-12);
  for (std::size_t i = 0; i + 1 < law.times().size(); ++i) {
    JointVector least, largest;
    law.extremes(i, 1, least, largest);
    EXPECT_GT(least[0], 0);
    EXPECT_LE(largest[0], 1 + 1e-8);
  }
}

// (F27)
TEST(SpeedProfile, KeepsRandomMotionsInsideTheirLimits) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int trial = 0; trial < 40; ++trial) {
    const double duration = std::pow(10, 2 * unit(random));
    const int points = 2 + static_cast<int>(300 * unit(random) * unit(random));
    const Trajectory motion =
        flip(points, duration, 1.5 * unit(random), duration * (0.005 + 0.2 * unit(random)),
             duration * unit(random));
    // A tenth to ten times what the motion takes.
    Rates own(2, 3);
    for (int k = 1; k <= 3; ++k) {
      for (int j = 0; j < 2; ++j) {
        double most = 1e-3;
        for (std::size_t i = 0; i + 1 < motion.times().size(); ++i) {
          JointVector least, largest;
          motion.extremes(i, k, least, largest);
          most = std::max({most, largest[j], -least[j]});
        }
        own(j, k - 1) = unit(random) < 0.2 ? kNone : most * std::pow(10, 2 * unit(random) - 1);
      }
    }
    SCOPED_TRACE(trial);
    const Trajectory law = speed_profile(motion, own);
    expect_a_law(motion, law);
    expect_limits_hold(motion, law, own);
    // No slower than slowing the whole motion, but for the margins.
    const double uniform = std::max(1.0, uniform_slowdown(motion, own).factor);
    EXPECT_LE(law.times().back() - law.times().front(), 1.03 * uniform * duration);
  }
}

TEST(SpeedProfile, SlowsOnlyAroundAFlipOfFiftyTimesTheLimit) {
  const Trajectory motion = flip(400, 50, 1.5, 0.3, 25);
  const Rates limit = limits(0.1001 / 0.98, 1, 10);
  const Trajectory law = speed_profile(motion, limit);
  EXPECT_GT(uniform_slowdown(motion, limit).factor, 45);
  expect_a_law(motion, law);
  expect_limits_hold(motion, law, limit);
  double slowed = 0;
  for (int i = 0; i < 1000; ++i) {
    const double tau = 2 + 0.05 * (i + 0.5);
    const double u = speed(law, real_time(law, tau));
    const double wanted = 0.1 / std::max(0.1, 5 / (1 + std::pow((tau - 27) / 0.3, 2)));
    EXPECT_LE(u, wanted + 0.01);  // what the velocity of joint 1 allows
    if (u < 0.99) slowed += 1e-3;
  }
  // The velocity alone asks for 0.3 s x sqrt(50) on either side.
  EXPECT_LT(slowed, 0.13);
}

TEST(SpeedProfile, RunsAtFullSpeedFarFromASpike) {
  for (const double jerk : {5.0, kNone}) {
    const Trajectory motion = flip(200, 50, 1.5, 0.5, 25);
    const Rates limit = limits(1, 1, jerk);
    const Trajectory law = speed_profile(motion, limit);
    expect_limits_hold(motion, law, limit);
    for (double tau = 2; tau < 52; tau += 0.1) {
      if (std::abs(tau - 27) > 3) {
        EXPECT_GT(speed(law, real_time(law, tau)), 0.9999) << tau;
      }
    }
    EXPECT_NEAR(speed(law, real_time(law, 27)), 0.98 * 1 / 3.0, 0.02);
  }
}

TEST(SpeedProfile, HalfTheLimitIsHalfTheSpeedAllAlong) {
  const Trajectory motion = flip(20, 10, 0, 1, 5);
  const Trajectory law = speed_profile(motion, limits(0.05, kNone, kNone), {1, 0});
  for (double t = law.times().front(); t < law.times().back(); t += 0.01) {
    EXPECT_NEAR(speed(law, t), 0.5, 0.004);
    EXPECT_LE(speed(law, t), 0.5);
  }
}

/// A joint that goes by q = tau^2 / 2 reaches its acceleration limit of 1/4 at a speed of 1/2 where
/// the speed is constant; with a ramp b' = -c b the optimum of q'' b + q' b' / 2 is that or less.
TEST(SpeedProfile, AccelerationOfAParabolaIsUsedToTheFull) {
  const auto vectors = [](std::vector<double> values) {
    std::vector<JointVector> list;
    for (const double value : values) list.push_back(JointVector::Constant(1, value));
    return list;
  };
  const Trajectory motion({0, 1, 2}, vectors({0, 0.5, 2}), vectors({0, 1, 2}), vectors({1, 1, 1}));
  Rates limit(1, 3);
  limit << kNone, 0.25, kNone;
  const Trajectory law = speed_profile(motion, limit, {1, 0});
  // q' = q'' t = t / 4 and q = t^2 / 8 = 2 at the end: 4 s.
  EXPECT_NEAR(law.times().back(), 4, 0.04);
  EXPECT_GE(law.times().back(), 4 - 1e-9);
}

TEST(SpeedProfile, WithoutLimitsNothingChanges) {
  const Trajectory motion = flip(100, 50, 1.5, 0.1, 25);
  const Trajectory law = speed_profile(motion, limits(kNone, kNone, kNone));
  for (double t = 2; t <= 52; t += 0.01) {
    EXPECT_NEAR(nominal(law, t), t, 1e-12);
    EXPECT_NEAR(speed(law, t), 1, 1e-12);
  }
}

TEST(SpeedProfile, TheMotionsTimesAreTimesOfTheLaw) {
  const Trajectory motion = flip(37, 50, 1.5, 0.5, 25);
  const Trajectory law = speed_profile(motion, limits(1, 1, 5));
  for (const double tau : motion.times()) {
    bool found = false;
    for (const JointVector& position : law.positions()) found = found || position[0] == tau;
    EXPECT_TRUE(found) << tau;
  }
}

TEST(SpeedProfile, OnlyTheMotionsTimesWhereThatIsAskedFor) {
  for (const int points : {2, 3, 12, 60}) {
    const Trajectory motion = flip(points, 50, 1.5, 3, 25);
    const Rates limit = limits(0.4, 0.5, 1);
    const Trajectory law = speed_profile(motion, limit, {0.98, 0, true});
    ASSERT_EQ(law.times().size(), motion.times().size());
    for (std::size_t i = 0; i < law.times().size(); ++i) {
      EXPECT_EQ(law.positions()[i][0], motion.times()[i]);
    }
    expect_a_law(motion, law);
    expect_limits_hold(motion, law, limit);
  }
}

TEST(SpeedProfile, AMotionThatBeginsAndEndsAtRest) {
  std::vector<JointVector> zero(2, JointVector::Zero(2));
  const Trajectory motion({0, 1}, {JointVector::Zero(2), JointVector::Ones(2)}, zero, zero);
  const Trajectory law = speed_profile(motion, limits(1, 1, 5));
  expect_a_law(motion, law);
  expect_limits_hold(motion, law, limits(1, 1, 5));
}

TEST(SpeedProfile, TenThousandWaypoints) {
  const Trajectory motion = flip(10000, 500, 1.5, 0.5, 250);
  const Rates limit = limits(0.5, 1, 5);
  const Trajectory law = speed_profile(motion, limit, {0.98, 0.5});
  expect_a_law(motion, law);
  expect_limits_hold(motion, law, limit, 100000);
  EXPECT_LT(law.times().back(), 520);
}

TEST(SpeedProfile, RejectsWhatMakesNoSense) {
  const Trajectory motion = flip(10, 10, 1, 1, 5);
  EXPECT_THROW(speed_profile(motion, limits(0, 1, 1)), InvalidInput);
  EXPECT_THROW(speed_profile(motion, limits(NAN, 1, 1)), InvalidInput);
  EXPECT_THROW(speed_profile(motion, Rates::Ones(3, 3)), InvalidInput);
  EXPECT_THROW(speed_profile(motion, limits(1, 1, 1), {0, 0}), InvalidInput);
  EXPECT_THROW(speed_profile(motion, limits(1, 1, 1), {0.9, -1}), InvalidInput);
  EXPECT_THROW(speed_profile(motion, limits(1, 1, 1), {0.9, INFINITY}), InvalidInput);
}

}  // namespace
}  // namespace wristwise
