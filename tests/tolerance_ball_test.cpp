#include "smoothing/tolerance_ball.hpp"

#include <gtest/gtest.h>

#include <random>

namespace wristwise {
namespace {

/// By the trace of the matrix, in long double near zero: nothing of quaternions or half angles.
double turn_of(const Eigen::Matrix3d& rotation) {
  const Eigen::Vector3d twice_sine(rotation(2, 1) - rotation(1, 2), rotation(0, 2) - rotation(2, 0),
                                   rotation(1, 0) - rotation(0, 1));
  return std::atan2(twice_sine.norm(), rotation.trace() - 1);
}

TEST(ToleranceBall, HoldsTheBox) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (const double angle : {1e-6, 1e-3, 0.0087, 0.3, 1.0, 2.0, 3.1}) {
    const ToleranceBox box = box_in_ball(2e-3, angle);
    box.validate("box");
    for (int i = 0; i < 2000; ++i) {
      Vector6 e;
      // Corners and edges as well as the inside.
      for (int k = 0; k < 6; ++k)
        e[k] = std::clamp(1.5 * uniform(random), -1.0, 1.0) * box.upper[k];
      const Pose pose = pose_at_deviation(box, Pose::Identity(), e);
      EXPECT_LE(pose.translation().norm(), 2e-3 * (1 + 1e-12));
      EXPECT_LE(turn_of(pose.linear()), angle * (1 + 1e-9));
    }
  }
}

TEST(ToleranceBall, IsTouchedByACorner) {
  for (const double angle : {1e-3, 0.0087, 0.3, 1.0, 2.0, 3.1}) {
    const ToleranceBox box = box_in_ball(2e-3, angle);
    const Pose pose = pose_at_deviation(box, Pose::Identity(), box.upper);
    EXPECT_NEAR(pose.translation().norm(), 2e-3, 1e-15);
    EXPECT_NEAR(turn_of(pose.linear()), angle, 1e-9);
  }
}

TEST(ToleranceBall, OfSmallAnglesIsThatOfPositions) {
  EXPECT_NEAR(box_in_ball(1, 1e-3).upper[3], 1e-3 / std::sqrt(3.0), 1e-6);
}

}  // namespace
}  // namespace wristwise
