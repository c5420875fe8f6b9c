// The torch slides along a plate for a third of the seam: clearance is active for that long, and
// the motion is smooth where it comes and goes. Distances are the test's own.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kuka_kr5_arc.hpp"
#include "wristwise/wristwise.hpp"

namespace wristwise {
namespace {

constexpr double kTorch = 0.3, kRadius = 0.02;  // m
constexpr double kClearance = 0.02;             // m
const Eigen::Vector3d kPlateCentre(0.845, 0, 0.47), kPlateHalf(0.01, 0.085, 0.05);

double distance_to_plate(const Eigen::Vector3d& point) {
  return ((point - kPlateCentre).cwiseAbs() - kPlateHalf).cwiseMax(0).norm();
}

/// The distance of a point that runs along the axis of the torch is convex: ternary search.
double torch_to_plate(const JointVector& q) {
  const Eigen::Vector3d from = test::kr5::tool0(q).topRightCorner<3, 1>();
  const Eigen::Vector3d along =
      Eigen::Vector3d(test::kr5::torch_tip(q, kTorch).topRightCorner<3, 1>()) - from;
  double low = 0, high = 1;
  for (int i = 0; i < 60; ++i) {
    const double a = (2 * low + high) / 3, b = (low + 2 * high) / 3;
    if (distance_to_plate(from + a * along) < distance_to_plate(from + b * along)) {
      high = b;
    } else {
      low = a;
    }
  }
  return distance_to_plate(from + low * along) - kRadius;
}

TEST(SlideAlongPlate, KeepsTheClearanceAndUsesItUpForAThirdOfTheTime) {
  const Problem problem =
      load_problem(std::string(WRISTWISE_SOURCE_DIR) + "/problems/slide_along_plate.yaml");
  const PlanResult result = plan(problem);
  ASSERT_EQ(result.status, Status::solved);

  constexpr int kSamples = 5000;
  const double duration = result.trajectory.times().back();
  int touching = 0;
  double least = 1, largest = 0;
  for (int i = 0; i <= kSamples; ++i) {
    const double distance = torch_to_plate(result.trajectory.evaluate(duration * i / kSamples));
    least = std::min(least, distance);
    largest = std::max(largest, distance);
    if (distance < kClearance + 1e-4) ++touching;
  }
  EXPECT_GE(least, kClearance - 1e-6);
  EXPECT_GT(largest, 5 * kClearance);  // elsewhere the plate is far away
  EXPECT_NEAR(static_cast<double>(touching) / kSamples, 1.0 / 3, 0.1);
  ASSERT_TRUE(result.verification.clearance_bound.has_value());
  EXPECT_GE(*result.verification.clearance_bound, kClearance - problem.refine.clearance_epsilon);
}

TEST(SlideAlongPlate, IsPressedAgainstThePlateByTheCostAlone) {
  Problem problem =
      load_problem(std::string(WRISTWISE_SOURCE_DIR) + "/problems/slide_along_plate.yaml");
  problem.scene.scope = CollisionScope::off;
  const PlanResult result = plan(problem);
  ASSERT_EQ(result.status, Status::solved);
  const double middle = 0.5 * result.trajectory.times().back();
  EXPECT_LT(torch_to_plate(result.trajectory.evaluate(middle)), 1e-3);
}

}  // namespace
}  // namespace wristwise
