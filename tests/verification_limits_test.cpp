#include <gtest/gtest.h>

#include "gantry.hpp"
#include "invalid_input.hpp"
#include "wristwise/verification.hpp"

namespace wristwise {
namespace {

namespace gantry = test::gantry;
using test::says;

constexpr double kJustAbove = 1 + 1e-6, kJustBelow = 1 - 1e-6;

/// Three waypoints in 2 s with room for any motion: only limits and clearance count.
Task roomy_task() { return gantry::task({{0, 0, 0}, {1, 0, 0}}, 2, 2, gantry::box(5, 3)); }

/// y(t) = amount (t - 1)^power, a quintic at most; x runs evenly.
Trajectory power_curve(int power, double amount) {
  std::vector<JointVector> derivative[3];
  for (const double t : {0.0, 1.0, 2.0}) {
    double factor = amount;
    for (int k = 0; k < 3; ++k) {
      const double y = k > power ? 0 : factor * std::pow(t - 1, power - k);
      const double x = k == 0 ? t / 2 : (k == 1 ? 0.5 : 0);
      derivative[k].push_back(gantry::posture(x, y, 0));
      factor *= power - k;
    }
  }
  return {{0, 1, 2}, derivative[0], derivative[1], derivative[2]};
}

std::shared_ptr<const ClearanceModel> limited(double velocity, double acceleration, double jerk) {
  Robot::Parts parts = gantry::parts();
  parts.joints[1].max_velocity = velocity;
  parts.joints[1].max_acceleration = acceleration;
  parts.joints[1].max_jerk = jerk;
  return gantry::clearance(gantry::robot(parts));
}

void expect_one_failure(const Verification& result, const std::vector<std::string>& parts) {
  EXPECT_FALSE(result.passed);
  ASSERT_EQ(result.failures.size(), 1U) << ::testing::PrintToString(result.failures);
  for (const std::string& part : parts) {
    EXPECT_TRUE(says(result.failures[0], part)) << result.failures[0] << " lacks " << part;
  }
}

/// y = a (t - 1)^3: |y'| <= 3 a, |y''| <= 6 a at the ends, |y'''| = 6 a.
TEST(VerificationLimits, RatesOfACurve) {
  const double a = 0.3, infinity = gantry::kUnlimited;
  const Trajectory curve = power_curve(3, a);
  const Task task = roomy_task();
  const auto check = [&](double velocity, double acceleration, double jerk) {
    return verify(task, limited(velocity, acceleration, jerk), curve);
  };
  const Verification just_passed =
      check(3 * a / kJustBelow, 6 * a / kJustBelow, 6 * a / kJustBelow);
  EXPECT_TRUE(just_passed.passed) << ::testing::PrintToString(just_passed.failures);
  EXPECT_NEAR(just_passed.velocity_ratio, kJustBelow, 1e-9);
  EXPECT_NEAR(just_passed.acceleration_ratio, kJustBelow, 1e-9);
  EXPECT_NEAR(just_passed.jerk_ratio, kJustBelow, 1e-9);
  EXPECT_EQ(just_passed.velocity_joint, 1);
  EXPECT_EQ(just_passed.acceleration_joint, 1);
  EXPECT_EQ(just_passed.jerk_joint, 1);

  const Verification fast = check(3 * a / kJustAbove, infinity, infinity);
  expect_one_failure(fast, {"velocity of y", "its limit at"});
  EXPECT_NEAR(fast.velocity_ratio, kJustAbove, 1e-9);
  expect_one_failure(check(infinity, 6 * a / kJustAbove, infinity), {"acceleration of y"});
  expect_one_failure(check(infinity, infinity, 6 * a / kJustAbove), {"jerk of y"});
}

/// y = a (t - 1)^4 - b (t - 1)^2 would peak inside a piece; a node curve with y' = 0 at every node
/// does: its largest speed is 15/8 of the mean one (minimum-jerk profile).
TEST(VerificationLimits, SpeedPeaksInsideAPiece) {
  const auto still = gantry::posture(0, 0, 0);
  const Trajectory curve({0, 1, 2}, {still, gantry::posture(0, 0.4, 0), gantry::posture(0, 0.4, 0)},
                         {still, still, still}, {still, still, still});
  const double peak = 15.0 / 8 * 0.4;
  const double infinity = gantry::kUnlimited;
  EXPECT_TRUE(verify(roomy_task(), limited(peak / kJustBelow, infinity, infinity), curve).passed);
  const Verification fast =
      verify(roomy_task(), limited(peak / kJustAbove, infinity, infinity), curve);
  expect_one_failure(fast, {"velocity of y", "at 0.5 s"});
  EXPECT_DOUBLE_EQ(fast.velocity_time, 0.5);
}

/// Steps 0, 0.4, 0.4 at 1 s: speed 0.4, divided second difference -0.4.
TEST(VerificationLimits, RatesOfPoints) {
  const JointPath path{
      {0, 1, 2},
      {gantry::posture(0, 0, 0), gantry::posture(0, 0.4, 0), gantry::posture(0, 0.4, 0)}};
  const double infinity = gantry::kUnlimited;
  const auto check = [&](double velocity, double acceleration) {
    return verify(roomy_task(), limited(velocity, acceleration, infinity), path);
  };
  EXPECT_TRUE(check(0.4 / kJustBelow, infinity).passed);
  expect_one_failure(check(0.4 / kJustAbove, infinity), {"velocity of y", "at 0.5 s"});
  const Verification rough = check(infinity, 0.4 / kJustAbove);
  EXPECT_TRUE(rough.passed);
  ASSERT_EQ(rough.warnings.size(), 1U);
  EXPECT_TRUE(says(rough.warnings[0], "acceleration of y"));
  EXPECT_NEAR(rough.acceleration_ratio, kJustAbove, 1e-9);
}

TEST(VerificationLimits, JointLimitAtAWaypoint) {
  Robot::Parts parts = gantry::parts();
  const auto check = [&](double upper) {
    parts.joints[0].upper = upper;
    const Task task = roomy_task();
    return verify(task, gantry::clearance(gantry::robot(parts)), gantry::path_along(task));
  };
  EXPECT_TRUE(check(1 - 0.9e-9).passed);
  const Verification beyond = check(1 - 2e-9);
  expect_one_failure(beyond, {"x is 2e-09 beyond its limit after 1 s"});
  EXPECT_NEAR(beyond.joint_limit_excess, 2e-9, 1e-12);
}

/// The curve turns back between waypoints: y = 0.3125 v half-way, 0 at both ends.
TEST(VerificationLimits, JointLimitThatACurveOvershootsBetweenWaypoints) {
  const double v = 0.4, peak = 0.3125 * v;
  const auto still = gantry::posture(0, 0, 0);
  const auto at = [](double x) { return gantry::posture(x, 0, 0); };
  for (const double side : {1.0, -1.0}) {
    const Trajectory curve({0, 1, 2}, {at(0), at(0.5), at(1)},
                           {gantry::posture(0.5, 0, 0), gantry::posture(0.5, side * v, 0),
                            gantry::posture(0.5, -side * v, 0)},
                           {still, still, still});
    const auto check = [&](double limit) {
      Robot::Parts parts = gantry::parts();
      parts.joints[1].lower = -limit;
      parts.joints[1].upper = limit;
      return verify(roomy_task(), gantry::clearance(gantry::robot(parts)), curve);
    };
    EXPECT_TRUE(check(peak - 0.5e-9).passed);
    expect_one_failure(check(peak - 1e-6), {"y is 1e-06 beyond its limit after 1 s"});
    // As points joined by straight moves the same rows keep the limit.
    Robot::Parts parts = gantry::parts();
    parts.joints[1].lower = parts.joints[1].upper = 0;
    EXPECT_TRUE(
        verify(roomy_task(), gantry::clearance(gantry::robot(parts)), curve.waypoints()).passed);
  }
}

}  // namespace
}  // namespace wristwise
