#include "wristwise/pose.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace wristwise {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr std::array<EulerSequence, 3> kSequences = {EulerSequence::xyz, EulerSequence::yzx,
                                                     EulerSequence::zxy};

Eigen::Matrix3d turn(int axis, double angle) {
  Eigen::Matrix3d r = Eigen::Matrix3d::Identity();
  const int a = (axis + 1) % 3, b = (axis + 2) % 3;
  r(a, a) = r(b, b) = std::cos(angle);
  r(a, b) = -std::sin(angle);
  r(b, a) = std::sin(angle);
  return r;
}

std::array<int, 3> order(EulerSequence sequence) {
  if (sequence == EulerSequence::yzx) return {1, 2, 0};
  if (sequence == EulerSequence::zxy) return {2, 0, 1};
  return {0, 1, 2};
}

Eigen::Matrix3d product(const Eigen::Vector3d& angles, EulerSequence sequence) {
  const auto axes = order(sequence);
  return turn(axes[0], angles[axes[0]]) * turn(axes[1], angles[axes[1]]) *
         turn(axes[2], angles[axes[2]]);
}

Eigen::Vector3d random_angles(std::mt19937& random, EulerSequence sequence) {
  std::uniform_real_distribution<double> full(-kPi, kPi), half(-kPi / 2, kPi / 2);
  Eigen::Vector3d angles(full(random), full(random), full(random));
  angles[order(sequence)[1]] = half(random);
  return angles;
}

TEST(EulerAngles, RecoverTheAnglesOfAProductOfTurns) {
  std::mt19937 random(1);
  for (const EulerSequence sequence : kSequences) {
    for (int i = 0; i < 1000; ++i) {
      const Eigen::Vector3d angles = random_angles(random, sequence);
      EXPECT_LT((euler_angles(product(angles, sequence), sequence) - angles).norm(), 1e-9)
          << angles.transpose();
    }
  }
}

TEST(EulerAngles, RebuildTheRotationWhereTheMiddleAngleIsARightAngle) {
  for (const EulerSequence sequence : kSequences) {
    for (const double offset : {0.0, 1e-14, 1e-10, 1e-6}) {
      for (const double sign : {-1.0, 1.0}) {
        Eigen::Vector3d angles(0.3, 0.3, 0.3);
        angles[order(sequence)[1]] = sign * (kPi / 2 - offset);
        const Eigen::Matrix3d rotation = product(angles, sequence);
        const Eigen::Vector3d found = euler_angles(rotation, sequence);
        EXPECT_LT((product(found, sequence) - rotation).norm(), 1e-12);
      }
    }
  }
}

TEST(EulerAngles, StayInTheirRange) {
  const Eigen::Matrix3d half_turn = turn(1, kPi);  // torch straight down
  const Eigen::Vector3d angles = euler_angles(half_turn);
  EXPECT_DOUBLE_EQ(angles.x(), kPi);
  EXPECT_NEAR(angles.y(), 0, 1e-15);
  EXPECT_DOUBLE_EQ(angles.z(), kPi);
}

TEST(EulerRateMatrix, TurnsAngularVelocityIntoRates) {
  std::mt19937 random(2);
  std::normal_distribution<double> normal;
  for (const EulerSequence sequence : kSequences) {
    for (int i = 0; i < 200; ++i) {
      Eigen::Vector3d angles = random_angles(random, sequence);
      angles[order(sequence)[1]] *= 0.9;
      const Eigen::Vector3d omega(normal(random), normal(random), normal(random));
      const double h = 1e-6;
      const auto turned = [&](double t) {
        return euler_angles(
            Eigen::AngleAxisd(omega.norm() * t, omega.normalized()) * product(angles, sequence),
            sequence);
      };
      Eigen::Vector3d difference = turned(h) - turned(-h);
      for (int k = 0; k < 3; ++k) difference[k] = std::remainder(difference[k], 2 * kPi);
      EXPECT_LT((euler_rate_matrix(angles, sequence) * omega - difference / (2 * h)).norm(), 1e-5);
    }
  }
}

TEST(PoseFromXyzRpy, TurnsAboutFixedAxes) {
  const Pose pose = pose_from_xyz_rpy({1, 2, 3}, {0.1, 0.2, 0.3});
  EXPECT_LT((pose.linear() - turn(2, 0.3) * turn(1, 0.2) * turn(0, 0.1)).norm(), 1e-15);
  EXPECT_EQ(pose.translation(), Eigen::Vector3d(1, 2, 3));
}

TEST(WrapAngle, IsHalfOpen) {
  EXPECT_DOUBLE_EQ(wrap_angle(-kPi), kPi);
  EXPECT_DOUBLE_EQ(wrap_angle(kPi), kPi);
  EXPECT_NEAR(wrap_angle(7 * kPi + 0.1), -kPi + 0.1, 1e-12);
  EXPECT_NEAR(wrap_angle(-0.3 - 4 * kPi), -0.3, 1e-12);
}

}  // namespace
}  // namespace wristwise
