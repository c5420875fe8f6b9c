#include "wristwise/tolerance.hpp"

#include <gtest/gtest.h>

#include <random>

#include "wristwise/error.hpp"

namespace wristwise {
namespace {

constexpr double kFree = ToleranceBox::kFree;

ToleranceBox box_with_free(const std::vector<int>& free, ToleranceFrame frame) {
  ToleranceBox box;
  box.frame = frame;
  box.lower << -0.01, -0.01, -0.01, -0.4, -0.4, -0.4;
  box.upper = -box.lower;
  for (const int k : free) {
    box.lower[k] = -kFree;
    box.upper[k] = kFree;
  }
  return box;
}

Pose random_pose(std::mt19937& random) {
  std::normal_distribution<double> normal;
  Pose pose = Pose::Identity();
  pose.linear() = Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random))
                      .normalized()
                      .toRotationMatrix();
  pose.translation() << normal(random), normal(random), normal(random);
  return pose;
}

TEST(Deviation, IsInvertedByThePoseAtThatDeviation) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> inside(-0.3, 0.3);
  for (const auto& free :
       std::vector<std::vector<int>>{{}, {5}, {3}, {4}, {3, 5}, {4, 5}, {3, 4}}) {
    const ToleranceBox box = box_with_free(free, ToleranceFrame::path);
    for (int i = 0; i < 200; ++i) {
      Vector6 e;
      for (int k = 0; k < 6; ++k) e[k] = inside(random) * (box.is_free(k) ? 10 : 1);
      const Pose frame = random_pose(random);
      const Vector6 found = deviation(box, frame, pose_at_deviation(box, frame, e));
      for (int k = 0; k < 6; ++k) EXPECT_NEAR(std::remainder(found[k] - e[k], 2 * M_PI), 0, 1e-9);
    }
  }
}

TEST(Deviation, FollowsTheWrittenConvention) {
  const ToleranceBox box = box_with_free({5}, ToleranceFrame::path);
  Pose frame = Pose::Identity();
  frame.linear() = Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitY()).toRotationMatrix();
  frame.translation() << 1, 2, 3;
  Pose tcp = frame * Eigen::Translation3d(0.1, 0.2, 0.3);
  tcp.linear() = frame.linear() * (Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitX()) *
                                   Eigen::AngleAxisd(0.2, Eigen::Vector3d::UnitY()) *
                                   Eigen::AngleAxisd(3.0, Eigen::Vector3d::UnitZ()))
                                      .toRotationMatrix();
  Vector6 expected;
  expected << 0.1, 0.2, 0.3, 0.1, 0.2, 3.0;
  EXPECT_LT((deviation(box, frame, tcp) - expected).norm(), 1e-12);
}

TEST(Deviation, InTheBaseFrameIsTheWrappedDifferenceOfAngles) {
  const ToleranceBox box = box_with_free({}, ToleranceFrame::base);
  Pose frame = Pose::Identity();
  frame.linear() = rotation_from_euler({3.1, 0.1, -3.1});
  Pose tcp = Pose::Identity();
  tcp.linear() = rotation_from_euler({-3.1, 0.3, 3.1});
  tcp.translation() << 0.1, 0.2, 0.3;
  Vector6 expected;
  expected << 0.1, 0.2, 0.3, 2 * M_PI - 6.2, 0.2, 6.2 - 2 * M_PI;
  EXPECT_LT((deviation(box, frame, tcp) - expected).norm(), 1e-12);
}

/// A fictitious robot whose joints are the six components of a twist about the TCP.
TEST(DeviationJacobian, EqualsNumericDifferences) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> inside(-0.35, 0.35);
  for (const ToleranceFrame frame_kind : {ToleranceFrame::path, ToleranceFrame::base}) {
    for (const auto& free : std::vector<std::vector<int>>{{}, {5}, {3}, {4}}) {
      const ToleranceBox box = box_with_free(free, frame_kind);
      for (int i = 0; i < 100; ++i) {
        Vector6 e;
        for (int k = 0; k < 6; ++k) e[k] = i == 0 ? 1e-9 : inside(random);
        Pose frame = Pose::Identity();
        frame.linear() = rotation_from_euler({inside(random), inside(random), inside(random)});
        const Pose tcp = pose_at_deviation(box, frame, e);
        const Jacobian twist = Jacobian::Identity(6, 6);
        const Jacobian analytic = deviation_jacobian(box, frame, tcp, twist);
        const double h = 1e-6;
        for (int k = 0; k < 6; ++k) {
          const auto moved = [&](double step) {
            Pose pose = tcp;
            if (k < 3) {
              pose.translation()[k] += step;
            } else {
              pose.linear() = Eigen::AngleAxisd(step, Eigen::Vector3d::Unit(k - 3)) * tcp.linear();
            }
            return deviation(box, frame, pose);
          };
          const Vector6 numeric = (moved(h) - moved(-h)) / (2 * h);
          EXPECT_LT((analytic.col(k) - numeric).cwiseAbs().maxCoeff(), 1e-7);
        }
      }
    }
  }
}

TEST(ToleranceBox, PutsTheFreeAngleLastAndABoundedOneInTheMiddle) {
  const auto sequence = [](const std::vector<int>& free) {
    return box_with_free(free, ToleranceFrame::path).sequence();
  };
  EXPECT_EQ(sequence({}), EulerSequence::xyz);
  EXPECT_EQ(sequence({5}), EulerSequence::xyz);
  EXPECT_EQ(sequence({3, 5}), EulerSequence::xyz);
  EXPECT_EQ(sequence({3}), EulerSequence::yzx);
  EXPECT_EQ(sequence({3, 4}), EulerSequence::yzx);
  EXPECT_EQ(sequence({4}), EulerSequence::zxy);
  EXPECT_EQ(sequence({4, 5}), EulerSequence::zxy);
}

TEST(ToleranceBox, RefusesBoundsThatMeanNothing) {
  const auto refused = [](int k, double lower, double upper) {
    ToleranceBox box = box_with_free({5}, ToleranceFrame::path);
    box.lower[k] = lower;
    box.upper[k] = upper;
    try {
      box.validate("path.tolerance");
    } catch (const InvalidInput& error) {
      return std::string(error.what()).find("path.tolerance.") == 0;
    }
    return false;
  };
  EXPECT_TRUE(refused(0, 0.1, -0.1));
  EXPECT_TRUE(refused(1, -kFree, kFree));
  EXPECT_TRUE(refused(3, std::nan(""), 0.1));
  EXPECT_TRUE(refused(4, -1.6, 1.6));
  EXPECT_TRUE(refused(5, -kFree, 0.1));
  EXPECT_FALSE(refused(3, -1.6, 1.6));  // not the middle angle
  EXPECT_FALSE(refused(4, -0.1, 0.2));
}

TEST(BoxExcess, IsTheDistanceBeyondEachBound) {
  const ToleranceBox box = box_with_free({5}, ToleranceFrame::path);
  Vector6 e, expected;
  e << 0.02, -0.03, 0.005, 0.5, -0.3, 100;
  expected << 0.01, 0.02, 0, 0.1, 0, 0;
  EXPECT_LT((box_excess(box, e) - expected).norm(), 1e-15);
  EXPECT_NEAR(box_excess(box.widened(0.01, 0.05), e)[3], 0.05, 1e-15);
}

}  // namespace
}  // namespace wristwise
