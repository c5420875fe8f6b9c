// The deviations that the verification reports for the KR 5 arc, against kinematics and Euler
// angles that share nothing with the library.

#include <gtest/gtest.h>

#include <random>

#include "kuka_kr5_arc.hpp"
#include "wristwise/verification.hpp"

namespace wristwise {
namespace {

namespace kr5 = test::kr5;

constexpr double kDuration = 4;  // s

/// Angles of R = Rx(alpha) Ry(beta) Rz(gamma), from the elements of the product.
Eigen::Vector3d angles(const Eigen::Matrix3d& r) {
  return {std::atan2(-r(1, 2), r(2, 2)), std::asin(r(0, 2)), std::atan2(-r(0, 1), r(0, 0))};
}

double wrapped(double angle) { return std::atan2(std::sin(angle), std::cos(angle)); }

Vector6 deviation_of(ToleranceFrame frame, const Eigen::Matrix4d& nominal,
                     const Eigen::Matrix4d& tcp) {
  const Eigen::Matrix3d p = nominal.topLeftCorner<3, 3>(), r = tcp.topLeftCorner<3, 3>();
  const Eigen::Vector3d offset = tcp.topRightCorner<3, 1>() - nominal.topRightCorner<3, 1>();
  Vector6 e;
  if (frame == ToleranceFrame::path) {
    e << p.transpose() * offset, angles(p.transpose() * r);
  } else {
    e << offset, (angles(r) - angles(p)).unaryExpr(&wrapped);
  }
  return e;
}

/// A straight seam that turns evenly about one axis.
struct Line {
  Eigen::Matrix4d from;
  Eigen::Vector3d travel, axis;
  double angle;

  Eigen::Matrix4d at(double share) const {
    Eigen::Matrix4d pose = from;
    pose.topRightCorner<3, 1>() += share * travel;
    // Rodrigues
    Eigen::Matrix3d k;
    k << 0, -axis.z(), axis.y(), axis.z(), 0, -axis.x(), -axis.y(), axis.x(), 0;
    const double a = share * angle;
    pose.topLeftCorner<3, 3>() *=
        Eigen::Matrix3d::Identity() + std::sin(a) * k + (1 - std::cos(a)) * k * k;
    return pose;
  }
};

struct Case {
  Task task;
  Line line;
  Trajectory trajectory;
};

/// A wavy motion about a posture, and a seam that starts where it does.
Case random_case(unsigned seed, const ToleranceBox& box) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> value(-1, 1);
  const auto random_vector = [&](double size) {
    JointVector q(6);
    for (double& x : q) x = size * value(random);
    return q;
  };
  JointVector centre(6);
  centre << 0.3, -1.3, 1.5, 0.4, 0.7, -0.5;
  centre += random_vector(0.1);
  std::vector<double> times;
  std::vector<JointVector> positions, velocities, accelerations;
  for (int i = 0; i <= 5; ++i) {
    times.push_back(kDuration * i / 5);
    positions.push_back(centre + random_vector(0.02));
    velocities.push_back(random_vector(0.05));
    accelerations.push_back(random_vector(0.1));
  }
  Case result;
  result.trajectory = Trajectory(times, positions, velocities, accelerations);
  result.line.from = kr5::torch_tip(centre, 0.3);
  result.line.travel << 0.02 * value(random), 0.02 * value(random), 0.02 * value(random);
  result.line.axis = Eigen::Vector3d(value(random), value(random), value(random)).normalized();
  result.line.angle = 0.2;
  SeamPiece piece;
  piece.from = Pose(result.line.at(0));
  piece.to = Pose(result.line.at(1));
  piece.end_time = kDuration;
  result.task.seam = Seam({piece});
  for (const double t : times) {
    Waypoint waypoint;
    waypoint.time = t;
    waypoint.frame = Pose(result.line.at(t / kDuration));
    waypoint.tolerance = box;
    result.task.waypoints.push_back(waypoint);
  }
  return result;
}

Vector6 excess_over(const ToleranceBox& box, double more_position, double more_angle,
                    const Vector6& e) {
  Vector6 excess = Vector6::Zero();
  for (int k = 0; k < 6; ++k) {
    const double more = k < 3 ? more_position : more_angle;
    excess[k] = std::max({0.0, box.lower[k] - more - e[k], e[k] - box.upper[k] - more});
  }
  return excess;
}

std::shared_ptr<const ClearanceModel> no_collision() {
  Scene scene;
  scene.scope = CollisionScope::off;
  return std::make_shared<const ClearanceModel>(kr5::load(), scene);
}

TEST(VerificationDeviation, EqualsAnIndependentCalculation) {
  const auto model = no_collision();
  for (const ToleranceFrame frame : {ToleranceFrame::path, ToleranceFrame::base}) {
    ToleranceBox box;
    box.frame = frame;
    box.lower << -0.001, 0, -0.003, -0.01, -0.02, -0.03;
    box.upper << 0.002, 0, 0.001, 0.005, 0.01, 0.01;
    for (unsigned seed = 0; seed < 10; ++seed) {
      Case given = random_case(seed, box);
      given.task.between_position = 5e-4;
      given.task.between_angle = 2e-3;
      const auto excess_at = [&](double t, double position, double angle) {
        const Vector6 e = deviation_of(frame, given.line.at(t / kDuration),
                                       kr5::torch_tip(given.trajectory.evaluate(t), 0.3));
        return excess_over(box, position, angle, e);
      };
      Vector6 at = Vector6::Zero(), between = Vector6::Zero();
      double position_error = 0;
      for (const double t : given.trajectory.times()) {
        at = at.cwiseMax(excess_at(t, 0, 0));
        position_error = std::max(position_error, excess_at(t, 0, 0).head<3>().norm());
      }
      for (int i = 0; i <= 20000; ++i) {
        between = between.cwiseMax(excess_at(kDuration * i / 20000, 5e-4, 2e-3));
      }
      VerificationOptions options;
      options.samples_per_interval = 1000;
      const Verification found = verify(given.task, model, given.trajectory, options);
      EXPECT_FALSE(found.passed);
      EXPECT_LT((found.tolerance_excess - at).cwiseAbs().maxCoeff(), 1e-9);
      EXPECT_NEAR(found.position_error, position_error, 1e-9);
      // Samples, not every time: below the true maximum, and near it.
      EXPECT_LT((found.tolerance_excess_between - between).maxCoeff(), 1e-9);
      EXPECT_GT((found.tolerance_excess_between - between).minCoeff(), -1e-4);
    }
  }
}

/// Without any samples the largest excess is found to within 2%.
TEST(VerificationDeviation, FindsTheLargestExcess) {
  const auto model = no_collision();
  VerificationOptions fine;
  fine.samples_per_interval = 1000;
  for (const ToleranceFrame frame : {ToleranceFrame::path, ToleranceFrame::base}) {
    ToleranceBox box;
    box.frame = frame;
    for (unsigned seed = 0; seed < 10; ++seed) {
      const Case given = random_case(seed, box);
      const Verification found = verify(given.task, model, given.trajectory);
      const Verification many = verify(given.task, model, given.trajectory, fine);
      EXPECT_FALSE(found.deviation_shown);
      EXPECT_GT(many.samples, found.samples);
      for (int k = 0; k < 6; ++k) {
        EXPECT_LE(many.tolerance_excess_between[k],
                  1.02 * found.tolerance_excess_between[k] + 1e-6);
        EXPECT_GE(many.tolerance_excess_between[k], found.tolerance_excess_between[k]);
      }
    }
  }
}

/// The bounds hold at every time, and are within 5% of the largest error.
TEST(VerificationDeviation, StatesThePathErrorForAllTimes) {
  const auto model = no_collision();
  for (const ToleranceFrame frame : {ToleranceFrame::path, ToleranceFrame::base}) {
    for (unsigned seed = 0; seed < 10; ++seed) {
      ToleranceBox box;
      box.frame = frame;
      box.lower = Vector6::Constant(-1);
      box.upper = -box.lower;
      if (seed % 2 == 1) box.lower[5] = -ToleranceBox::kFree, box.upper[5] = ToleranceBox::kFree;
      const Case given = random_case(seed, box);
      const Verification found = verify(given.task, model, given.trajectory);
      EXPECT_TRUE(found.deviation_shown);
      double position = 0, angle = 0;
      for (int i = 0; i <= 20000; ++i) {
        const double t = kDuration * i / 20000;
        const Vector6 e = deviation_of(frame, given.line.at(t / kDuration),
                                       kr5::torch_tip(given.trajectory.evaluate(t), 0.3));
        position = std::max(position, e.head<3>().norm());
        angle = std::max(angle, e.segment(3, seed % 2 == 1 ? 2 : 3).cwiseAbs().maxCoeff());
      }
      EXPECT_GE(found.path_error, position - 1e-12);
      EXPECT_LE(found.path_error, 1.05 * position + 1e-5);
      EXPECT_GE(found.angle_error, angle - 1e-9);
      EXPECT_LE(found.angle_error, 1.05 * angle + 1e-5);
    }
  }
}

/// An excursion of 0.2 ms that ten samples an interval, and a thousand, step over.
TEST(VerificationDeviation, CatchesAnExcursionBetweenSamples) {
  const auto model = no_collision();
  ToleranceBox box;
  box.lower = Vector6::Constant(-0.5);
  box.upper = -box.lower;
  const Case given = random_case(3, box);
  const Trajectory& smooth = given.trajectory;
  std::vector<double> times;
  std::vector<JointVector> positions, velocities, accelerations;
  const double bump_at = 1.23456;
  const double half = 5e-5;  // s
  for (const double t : {0.0, 0.8, bump_at - 2 * half, bump_at - half, bump_at + half,
                         bump_at + 2 * half, 1.6, kDuration}) {
    times.push_back(t);
    positions.push_back(smooth.evaluate(t));
    velocities.push_back(smooth.evaluate(t, 1));
    accelerations.push_back(smooth.evaluate(t, 2));
  }
  const auto check = [&] {
    return verify(given.task, model, Trajectory(times, positions, velocities, accelerations));
  };
  EXPECT_TRUE(check().deviation_shown);
  velocities[3][4] += 2e4;  // out and in again: 0.6 rad away in the middle
  velocities[4][4] -= 2e4;
  const Verification found = check();
  EXPECT_FALSE(found.deviation_shown);
  ASSERT_FALSE(found.deviation_not_shown.empty());
  EXPECT_GE(found.deviation_not_shown.front().from, bump_at - 1e-4);
  EXPECT_LE(found.deviation_not_shown.front().from, bump_at);
  EXPECT_GE(found.deviation_not_shown.back().to, bump_at);
  EXPECT_LE(found.deviation_not_shown.back().to, bump_at + 1e-4);
  EXPECT_GT(found.tolerance_excess_between.maxCoeff(), 0.05);
  EXPECT_LT((found.tolerance_excess).maxCoeff(), 1e-6);
}

}  // namespace
}  // namespace wristwise
