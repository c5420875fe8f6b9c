#pragma once

// Six-axis arms with a spherical wrist in every convention, at random.

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <string>

#include "wristwise/robot.hpp"

namespace wristwise::test {

/// Seeded random values.
class Dice {
 public:
  static constexpr double kPi = 3.14159265358979323846;

  explicit Dice(unsigned seed) : rng_(seed) {}
  double uniform(double lower, double upper) {
    return std::uniform_real_distribution<double>(lower, upper)(rng_);
  }
  double sign() { return uniform(-1, 1) < 0 ? -1 : 1; }
  Eigen::Vector3d vector(double size) {
    return {uniform(-size, size), uniform(-size, size), uniform(-size, size)};
  }
  Eigen::Matrix3d rotation() {
    std::normal_distribution<double> value;
    return Eigen::Quaterniond(value(rng_), value(rng_), value(rng_), value(rng_))
        .normalized()
        .toRotationMatrix();
  }
  JointVector posture(int joints = 6) {
    JointVector q(joints);
    for (double& angle : q) angle = uniform(-kPi, kPi);
    return q;
  }

 private:
  std::mt19937 rng_;
};

/// An arm by its axes at zero: point and direction of each, and the TCP, all in base. Link frames
/// are arbitrary, so that nothing but the axes can matter.
inline Robot arm_from_axes(const std::array<Eigen::Vector3d, 6>& points,
                           const std::array<Eigen::Vector3d, 6>& directions, const Pose& tcp,
                           Dice& dice) {
  Robot::Parts parts;
  parts.name = "random arm";
  Pose previous = Pose::Identity();
  for (std::size_t j = 0; j < 6; ++j) {
    Pose frame = Pose::Identity();
    frame.linear() = dice.rotation();
    frame.translation() = points[j] + dice.uniform(-0.2, 0.2) * directions[j];
    Joint joint;
    joint.name = "j" + std::to_string(j + 1);
    joint.type = JointType::continuous;
    joint.lower = -std::numeric_limits<double>::infinity();
    joint.upper = std::numeric_limits<double>::infinity();
    joint.max_velocity = joint.max_acceleration = joint.max_jerk = 1;
    joint.origin = previous.inverse() * frame;
    joint.axis = frame.linear().transpose() * directions[j];
    parts.joints.push_back(joint);
    previous = frame;
  }
  parts.tcp = previous.inverse() * tcp;
  return Robot(parts);
}

struct ArmChoice {
  bool perpendicular_shoulder = true;
  bool perpendicular_wrist = true;
};

/// A random arm with parallel axes 2 and 3 and a spherical wrist, anywhere, in any zero posture.
inline Robot random_arm(Dice& dice, const ArmChoice& choice) {
  const auto tilted = [&](const Eigen::Vector3d& axis, bool perpendicular) {
    const Eigen::Vector3d side = axis.cross(dice.rotation().col(0)).normalized();
    const double angle = perpendicular ? Dice::kPi / 2 : dice.uniform(0.6, 2.4);
    return Eigen::Vector3d(Eigen::AngleAxisd(angle, side) * axis);
  };
  std::array<Eigen::Vector3d, 6> h, p;
  h[0] = dice.rotation().col(2);
  h[1] = tilted(h[0], choice.perpendicular_shoulder);
  h[2] = dice.sign() * h[1];
  h[3] = dice.rotation().col(2);
  h[4] = tilted(h[3], choice.perpendicular_wrist);
  h[5] = tilted(h[4], choice.perpendicular_wrist);
  p[0] = dice.vector(1);
  p[1] = p[0] + dice.vector(0.3);
  p[2] = p[1] + dice.uniform(0.3, 0.8) * h[1].cross(dice.rotation().col(0)).normalized();
  const Eigen::Vector3d wrist =
      p[2] + dice.vector(0.2) +
      dice.uniform(0.3, 0.8) * h[1].cross(dice.rotation().col(0)).normalized();
  p[3] = p[4] = p[5] = wrist;
  Pose tcp = Pose::Identity();
  tcp.linear() = dice.rotation();
  tcp.translation() = wrist + dice.vector(0.4);
  return arm_from_axes(p, h, tcp, dice);
}

}  // namespace wristwise::test
