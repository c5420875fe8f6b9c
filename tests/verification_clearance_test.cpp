#include <gtest/gtest.h>

#include <cmath>

#include "gantry.hpp"
#include "invalid_input.hpp"
#include "wristwise/verification.hpp"

namespace wristwise {
namespace {

namespace gantry = test::gantry;
using test::says;

constexpr double kBall = 0.002, kRequired = 0.003;  // m

Task straight_task() { return gantry::task({{0, 0, 0}, {1, 0, 0}}, 5, 5, gantry::box(0.01, 0.1)); }

Trajectory even_curve(const JointPath& path) {
  std::vector<JointVector> velocities(path.size(), gantry::posture(0.2, 0, 0));
  std::vector<JointVector> accelerations(path.size(), gantry::posture(0, 0, 0));
  return {path.times, path.positions, velocities, accelerations};
}

std::vector<Verification> both_forms(const SceneObject& object) {
  const Task task = straight_task();
  const auto model = gantry::clearance(gantry::robot(gantry::parts(kBall)), {object}, kRequired);
  const JointPath path = gantry::path_along(task);
  return {verify(task, model, path), verify(task, model, even_curve(path))};
}

void expect_clearance_failure(const Verification& result) {
  EXPECT_FALSE(result.passed);
  EXPECT_FALSE(result.clearance_bound.has_value());
  ASSERT_EQ(result.failures.size(), 1U) << ::testing::PrintToString(result.failures);
  EXPECT_TRUE(says(result.failures[0], "ball - obstacle"));
  EXPECT_TRUE(says(result.failures[0], "3 mm required"));
}

/// A plate thinner than the distance of any two samples, across the way between the third and the
/// fourth waypoint, and between two of the ten samples there.
TEST(VerificationClearance, CatchesAThinPlateBetweenWaypoints) {
  for (const Verification& result : both_forms(gantry::obstacle(Box{{1e-4, 1, 1}}, 0.45, 0, 0))) {
    expect_clearance_failure(result);
    EXPECT_NEAR(result.clearance_time, 2.25, 0.04);
    EXPECT_LT(*result.clearance, kRequired);
    EXPECT_EQ(result.clearance_pair, ClearanceModel::Names("ball", "obstacle"));
  }
}

/// A needle's tip that the ball passes at a distance between samples.
TEST(VerificationClearance, CatchesANearMissBetweenWaypoints) {
  const double needle = 0.0005;
  for (const double missing : {1e-4, 1e-3}) {
    const double y = kBall + needle + kRequired - missing;
    for (const Verification& result : both_forms(gantry::obstacle(Sphere{needle}, 0.51, y, 0))) {
      expect_clearance_failure(result);
      EXPECT_NEAR(result.clearance_time, 2.55, 0.05);
    }
  }
  const double y = kBall + needle + kRequired + 1e-5;
  for (const Verification& result : both_forms(gantry::obstacle(Sphere{needle}, 0.51, y, 0))) {
    EXPECT_TRUE(result.passed);
    EXPECT_GE(*result.clearance_bound, kRequired - 5e-5);
    EXPECT_LE(*result.clearance_bound, kRequired + 1e-5 + 1e-9);
    EXPECT_GE(*result.clearance, *result.clearance_bound);
  }
}

TEST(VerificationClearance, CatchesAPenetrationAtAWaypoint) {
  for (const Verification& result : both_forms(gantry::obstacle(Sphere{0.05}, 0.4, 0.03, 0))) {
    expect_clearance_failure(result);
    EXPECT_NEAR(result.clearance_time, 2, 1e-9);
    EXPECT_NEAR(*result.clearance, 0.03 - 0.052, 1e-6);
    EXPECT_TRUE(says(result.failures[0], "-22 mm apart at 2 s"));
  }
}

TEST(VerificationClearance, HoldsToAMicrometreAtSamples) {
  for (const auto& [slack, passes] : std::vector<std::pair<double, bool>>{
           {1e-6, true}, {-0.5e-6, true}, {-3e-6, false}, {-1e-4, false}}) {
    // The ball slides along a plate.
    const double height = kBall + kRequired + slack;
    for (const Verification& result :
         both_forms(gantry::obstacle(Box{{4, 4, 0.1}}, 0, 0, -height - 0.05))) {
      EXPECT_EQ(result.passed, passes) << slack;
      EXPECT_NEAR(*result.clearance, kRequired + slack, 1e-9);
    }
  }
}

/// The curve bulges towards an obstacle that straight moves between its rows would pass.
TEST(VerificationClearance, FollowsTheCurveAndNotItsChords) {
  const Task task = gantry::task({{0, 0, 0}, {1, 0, 0}}, 5, 5, gantry::box(0.5, 0.1));
  const auto model =
      gantry::clearance(gantry::robot(gantry::parts(kBall)),
                        {gantry::obstacle(Sphere{0.002}, 0.5, 0.3125 * 0.1, 0)}, kRequired);
  const JointPath path = gantry::path_along(task);
  std::vector<JointVector> velocities(path.size(), gantry::posture(0.2, 0, 0));
  velocities[2][1] = 0.1;
  velocities[3][1] = -0.1;
  const Trajectory curve(path.times, path.positions, velocities,
                         std::vector<JointVector>(path.size(), gantry::posture(0, 0, 0)));
  const Verification bulging = verify(task, model, curve);
  expect_clearance_failure(bulging);
  EXPECT_NEAR(bulging.clearance_time, 2.5, 1e-6);
  EXPECT_NEAR(*bulging.clearance, -0.004, 1e-6);
  EXPECT_TRUE(verify(task, model, path).passed);
}

/// The certificate is refuted where a needle is planted, and nowhere else.
TEST(VerificationClearance, NamesTheIntervalThatIsNotShown) {
  const double needle = 0.0005, reach = kBall + needle + kRequired;
  SceneObject first = gantry::obstacle(Sphere{needle}, 0.51, reach - 1e-3, 0);
  SceneObject second = gantry::obstacle(Sphere{needle}, 0.91, reach - 1e-3, 0);
  second.name = "other";
  const Task task = straight_task();
  const auto model =
      gantry::clearance(gantry::robot(gantry::parts(kBall)), {first, second}, kRequired);
  const JointPath path = gantry::path_along(task);
  for (const Verification& result :
       {verify(task, model, path), verify(task, model, even_curve(path))}) {
    EXPECT_FALSE(result.clearance_bound);
    ASSERT_EQ(result.clearance_not_shown.size(), 2U);
    // The needle is too near where |x - 0.51| is below this; the ball runs at 0.2 m/s.
    const double near = std::sqrt(std::pow(reach - 5e-5, 2) - std::pow(reach - 1e-3, 2));
    const auto expect_at = [&](const UnshownClearance& unshown, double x, const std::string& name) {
      EXPECT_EQ(unshown.pair, ClearanceModel::Names("ball", name));
      EXPECT_LE(unshown.range.from, (x - near) / 0.2);
      EXPECT_GE(unshown.range.to, (x + near) / 0.2);
      EXPECT_GT(unshown.range.from, (x - near) / 0.2 - 0.1);
      EXPECT_LT(unshown.range.to, (x + near) / 0.2 + 0.1);
    };
    expect_at(result.clearance_not_shown[0], 0.51, "obstacle");
    expect_at(result.clearance_not_shown[1], 0.91, "other");
  }
}

/// Without samples the least distance of all times is found to within a fifth of epsilon.
TEST(VerificationClearance, FindsTheLeastDistance) {
  for (const double x : {0.0, 0.123, 0.51, 0.777, 1.0}) {
    const double y = 0.05;
    for (const Verification& result : both_forms(gantry::obstacle(Sphere{0.01}, x, y, 0))) {
      EXPECT_TRUE(result.passed);
      EXPECT_NEAR(*result.clearance, y - 0.01 - kBall, 1e-5);
      EXPECT_GE(*result.clearance, y - 0.01 - kBall - 1e-6);
      EXPECT_LE(*result.clearance_bound, y - 0.01 - kBall + 1e-9);
      EXPECT_GE(*result.clearance_bound, *result.clearance - 1e-5);
      EXPECT_TRUE(result.clearance_not_shown.empty());
    }
  }
}

}  // namespace
}  // namespace wristwise
