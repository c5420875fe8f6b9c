// Smoothing recorded paths without a problem, on chains with and without a closed form. The TCP is
// computed by the test's own forward kinematics.

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "io/peaks.hpp"
#include "kuka_kr5_arc.hpp"
#include "recording.hpp"
#include "wristwise/smoothing.hpp"

namespace wristwise {
namespace {

using test::joint_vector;
using test::record;
using test::recording_times;
using test::Swing;
using Tcp = std::function<Eigen::Matrix4d(const JointVector&)>;

constexpr double kDegree = 0.017453292519943295;
constexpr double kAccepted = 2e-6;  // m and rad: what the check accepts at waypoints

Eigen::Matrix4d shift_x(double x) { return test::kr5::shift({x, 0, 0}); }

/// Three links of 0.4, 0.3 and 0.2 m in the plane: the TCP reaches three of six coordinates.
const std::vector<double> kPlanarLinks = {0.4, 0.3, 0.2};

Swing planar_swing() {
  return {joint_vector({0.3, 0.9, -0.5}), joint_vector({0.4, 0.3, 0.5}),
          joint_vector({0.8, 1.1, 0.6})};
}

Eigen::Matrix4d planar_tcp(const JointVector& q) {
  Eigen::Matrix4d tcp = Eigen::Matrix4d::Identity();
  for (int j = 0; j < 3; ++j)
    tcp = tcp * test::kr5::turn(2, q[j]) * shift_x(kPlanarLinks[static_cast<std::size_t>(j)]);
  return tcp;
}

Joint joint(const std::string& name, JointType type, const Eigen::Vector3d& offset,
            const Eigen::Vector3d& axis) {
  Joint result;
  result.name = name;
  result.type = type;
  result.origin.translation() = offset;
  result.axis = axis;
  result.lower = -3;
  result.upper = 3;
  result.max_velocity = 2;
  result.max_acceleration = 10;
  result.max_jerk = 100;
  return result;
}

Robot::Parts planar_parts() {
  Robot::Parts parts;
  parts.name = "planar";
  double length = 0;
  for (int j = 0; j < 3; ++j) {
    parts.joints.push_back(joint("j" + std::to_string(j), JointType::revolute, {length, 0, 0},
                                 Eigen::Vector3d::UnitZ()));
    length = kPlanarLinks[static_cast<std::size_t>(j)];
  }
  parts.tcp.translation().x() = length;
  return parts;
}

/// A rail that carries a seven-axis arm whose axes are z and y in turn, the last one without end.
Robot::Parts rail_arm_parts() {
  Robot::Parts parts;
  parts.name = "arm on a rail";
  parts.joints.push_back(
      joint("rail", JointType::prismatic, Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitX()));
  for (int j = 0; j < 7; ++j) {
    parts.joints.push_back(joint("a" + std::to_string(j + 1), JointType::revolute, {0, 0, 0.2},
                                 j % 2 == 0 ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d::UnitY()));
  }
  Joint& last = parts.joints.back();
  last.type = JointType::continuous;
  last.lower = -std::numeric_limits<double>::infinity();
  last.upper = std::numeric_limits<double>::infinity();
  parts.tcp.translation().z() = 0.1;
  return parts;
}

Eigen::Matrix4d rail_arm_tcp(const JointVector& q) {
  Eigen::Matrix4d tcp = shift_x(q[0]);
  for (int j = 0; j < 7; ++j)
    tcp = tcp * test::kr5::shift({0, 0, 0.2}) * test::kr5::turn(j % 2 == 0 ? 2 : 1, q[j + 1]);
  return tcp * test::kr5::shift({0, 0, 0.1});
}

std::shared_ptr<const Robot> robot(const Robot::Parts& parts) {
  return std::make_shared<const Robot>(parts);
}

JointVector on_straight_moves(const JointPath& path, double t) {
  const auto after = std::upper_bound(path.times.begin() + 1, path.times.end() - 1, t);
  const auto i = static_cast<std::size_t>(after - path.times.begin());
  const double s = (t - path.times[i - 1]) / (path.times[i] - path.times[i - 1]);
  return (1 - s) * path.positions[i - 1] + s * path.positions[i];
}

struct Stray {
  double position = 0, angle = 0;
};

/// How far the curve's TCP is from where the path has it, at the path's points and between them.
Stray stray(const JointPath& path, const Trajectory& curve, const Tcp& tcp) {
  Stray most;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    for (const double s : {0.0, 0.2, 0.4, 0.6, 0.8, 1.0}) {
      const double t = (1 - s) * path.times[i] + s * path.times[i + 1];
      const Eigen::Matrix4d a = tcp(on_straight_moves(path, t)), b = tcp(curve.evaluate(t));
      most.position =
          std::max(most.position, (a.topRightCorner<3, 1>() - b.topRightCorner<3, 1>()).norm());
      const Eigen::Matrix3d turn = a.topLeftCorner<3, 3>().transpose() * b.topLeftCorner<3, 3>();
      most.angle = std::max(most.angle, Eigen::AngleAxisd(turn).angle());
    }
  }
  return most;
}

void expect_kept(const JointPath& path, const PlanResult& result, const Tcp& tcp,
                 const SmoothingOptions& options = {}) {
  ASSERT_EQ(result.status, Status::solved)
      << (result.diagnosis.empty() ? "" : result.diagnosis.front().detail);
  EXPECT_DOUBLE_EQ(result.trajectory.times().front(), path.times.front());
  EXPECT_DOUBLE_EQ(result.trajectory.times().back(), path.times.back());
  const Stray most = stray(path, result.trajectory, tcp);
  EXPECT_LE(most.position, options.position_tolerance + kAccepted);
  EXPECT_LE(most.angle, options.angle_tolerance + kAccepted);
}

/// The least factor, over joints, by which a peak became smaller.
double gain(const PlanResult& result, int order) {
  const JointVector before = *peak_derivative(result.before->path, order);
  const JointVector after = peak_derivative(result.trajectory, order);
  return (before.array() / after.array()).minCoeff();
}

Eigen::Matrix4d torch_tcp(const JointVector& q) { return test::kr5::torch_tip(q, 0.3); }

TEST(OfflineSmoothing, NoisyRecordingOfAWeldingRobot) {
  const Swing swing = test::kr5_swing();
  const JointPath path = record(swing, recording_times(600, 0.01), 2e-5);
  const PlanResult result = smooth(test::kr5::load(), path, {});
  expect_kept(path, result, torch_tcp);
  EXPECT_GT(gain(result, 2), 30);
  EXPECT_GT(gain(result, 3), 1000);
  EXPECT_FALSE(violations_of(result.before->verification).empty());
  EXPECT_TRUE(violations_of(result.verification).empty());
  // What is left is the motion that was recorded, not its noise.
  const JointVector peaks = peak_derivative(result.trajectory, 2);
  for (int j = 0; j < 6; ++j)
    EXPECT_LT(peaks[j], 1.5 * swing.sweep[j] * std::pow(swing.rate[j], 2));
}

// Of each span of the curve most rows are no constraint points at first, and noise puts some of
// them outside: they have to join before the constraints are stiff.
TEST(OfflineSmoothing, NoisyRowsCloseTogether) {
  for (const double noise : {2e-5, 5e-5}) {
    const JointPath path =
        record(test::kr5_swing(), recording_times(noise < 3e-5 ? 6000 : 3000, 0.001), noise);
    const PlanResult result = smooth(test::kr5::load(), path, {});
    expect_kept(path, result, torch_tcp);
    EXPECT_GT(gain(result, 3), 1000);
  }
}

TEST(OfflineSmoothing, WrappedAnglesAreUndone) {
  Swing swing = test::kr5_swing();
  swing.middle[5] = 3.1;
  const JointPath path = record(swing, recording_times(300, 0.02), 1e-5);
  JointPath wrapped = path;
  for (JointVector& q : wrapped.positions) q[5] = wrap_angle(q[5]);
  const PlanResult result = smooth(test::kr5::load(), wrapped, {});
  expect_kept(path, result, torch_tcp);
  ASSERT_EQ(result.warnings.size(), 1u);
  EXPECT_NE(result.warnings[0].find("joint_a6"), std::string::npos);
}

TEST(OfflineSmoothing, PlanarArmWithJitter) {
  const Swing swing = planar_swing();
  for (const bool jitter : {false, true}) {
    const JointPath path = record(swing, recording_times(500, 0.01, jitter), 1e-4);
    const PlanResult result = smooth(robot(planar_parts()), path, {});
    expect_kept(path, result, planar_tcp);
    EXPECT_GT(gain(result, 2), 10) << jitter;
    EXPECT_GT(gain(result, 3), 100) << jitter;
  }
}

TEST(OfflineSmoothing, SevenJointsOnARail) {
  const Swing swing = {joint_vector({0.2, 0.1, 0.6, -0.3, 0.9, 0.4, -0.8, 40}),
                       joint_vector({0.3, 0.3, 0.2, 0.3, 0.2, 0.4, 0.3, 2}),
                       joint_vector({0.5, 0.4, 0.7, 0.3, 0.6, 0.5, 0.4, 0.3})};
  const JointPath path = record(swing, recording_times(400, 0.02), 3e-5);
  const PlanResult result = smooth(robot(rail_arm_parts()), path, {});
  expect_kept(path, result, rail_arm_tcp);
  EXPECT_GT(gain(result, 2), 3);
  EXPECT_GT(gain(result, 3), 30);
}

TEST(OfflineSmoothing, WideToleranceGainsMore) {
  const Swing swing = planar_swing();
  const JointPath path = record(swing, recording_times(200, 0.02), 1e-4);
  SmoothingOptions narrow, wide;
  narrow.smoothing_time = wide.smoothing_time = 0.5;
  wide.position_tolerance = 5e-3;
  wide.angle_tolerance = 5 * kDegree;
  const PlanResult a = smooth(robot(planar_parts()), path, narrow);
  const PlanResult b = smooth(robot(planar_parts()), path, wide);
  expect_kept(path, a, planar_tcp, narrow);
  expect_kept(path, b, planar_tcp, wide);
  EXPECT_LT(b.refine.objective, a.refine.objective);
}

TEST(OfflineSmoothing, TaughtPointsFarApart) {
  JointPath path;
  for (int i = 0; i <= 8; ++i) {
    path.times.push_back(i);
    path.positions.push_back(
        joint_vector({0.1 * i, 0.9 + 0.01 * i * i, -0.5 + 0.05 * i - 0.003 * i * i}));
  }
  SmoothingOptions options;
  options.position_tolerance = 2e-3;
  options.angle_tolerance = 1 * kDegree;
  const PlanResult result = smooth(robot(planar_parts()), path, options);
  expect_kept(path, result, planar_tcp, options);
}

/// Time along the motion: it halts from 2 s to 3 s, slowing down and speeding up in half a second.
double halting(double t) {
  const double slow = std::clamp((t - 1.5) / 0.5, 0.0, 1.0);
  const double fast = std::clamp((t - 3.0) / 0.5, 0.0, 1.0);
  return std::min(t, 1.5) + std::max(t - 3.5, 0.0) +
         0.5 * (slow - std::pow(slow, 3) + 0.5 * std::pow(slow, 4)) +
         0.5 * (std::pow(fast, 3) - 0.5 * std::pow(fast, 4));
}

TEST(OfflineSmoothing, RobotThatWaits) {
  const Swing swing = planar_swing();
  JointPath path;
  for (const double t : recording_times(300, 0.02)) {
    path.times.push_back(t);
    path.positions.push_back(swing.at(halting(t)));
  }
  ASSERT_EQ(path.positions[110], path.positions[140]);
  const PlanResult result = smooth(robot(planar_parts()), path, {});
  expect_kept(path, result, planar_tcp);
}

TEST(OfflineSmoothing, FromRestToRestStaysSo) {
  const Swing swing = planar_swing();
  JointPath path = record(swing, recording_times(300, 0.01), 2e-5);
  const auto eased = [](double t) {  // at rest for 0.5 s at both ends, of 3 s
    const double u = std::clamp((t - 0.5) / 2, 0.0, 1.0);
    return 2 * u * u * u * (10 - 15 * u + 6 * u * u);
  };
  for (std::size_t i = 0; i < path.size(); ++i)
    path.positions[i] += swing.at(eased(path.times[i])) - swing.at(path.times[i]);
  const PlanResult result = smooth(robot(planar_parts()), path, {});
  expect_kept(path, result, planar_tcp);
  for (const double t : {path.times.front(), path.times.back()}) {
    EXPECT_LT(result.trajectory.evaluate(t, 1).norm(), 1e-9) << t;
    EXPECT_LT(result.trajectory.evaluate(t, 2).norm(), 1e-9) << t;
  }
}

TEST(OfflineSmoothing, RobotThatNeverMoves) {
  JointPath path;
  for (int i = 0; i < 50; ++i) {
    path.times.push_back(0.02 * i);
    path.positions.push_back(joint_vector({0.3, 0.9, -0.5}));
  }
  const PlanResult result = smooth(robot(planar_parts()), path, {});
  expect_kept(path, result, planar_tcp);
}

TEST(OfflineSmoothing, BeyondJointLimitsIsReportedAndRepaired) {
  Robot::Parts parts = planar_parts();
  const Swing swing = planar_swing();
  const JointPath path = record(swing, recording_times(300, 0.02), 1e-5);
  parts.joints[1].upper = 1.2 - 2e-4;
  const PlanResult result = smooth(robot(parts), path, {});
  EXPECT_NEAR(result.before->verification.joint_limit_excess, 2e-4, 1e-4);
  EXPECT_FALSE(result.before->verification.passed);
  expect_kept(path, result, planar_tcp);
  EXPECT_EQ(result.verification.joint_limit_excess, 0);
}

}  // namespace
}  // namespace wristwise
