#include "kinematics/singularity.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <random>

namespace wristwise {

// (F20) Wrist: |a_(n-2) x a_n|, the sine of the angle between the axes that line up where a
// spherical wrist is singular. Manipulability: sqrt(det(J J^T)) (Yoshikawa, Int. J. Robotics
// Research 4(2), 1985; of J^T J where the chain has fewer than six joints), with the rows of the
// translation divided by the arm's length so that they have no unit, relative to the largest value
// among kPostures random postures.

namespace {

constexpr int kPostures = 512;
constexpr double kPi = 3.14159265358979323846;

double reach(const Robot& robot) {
  double sum = robot.tcp().translation().norm();
  for (const Joint& joint : robot.joints()) sum += joint.origin.translation().norm();
  return sum > 0 ? sum : 1;
}

/// In [0, 1), the same on every platform.
double fraction(std::mt19937& random) { return static_cast<double>(random()) / 4294967296.0; }

JointVector random_posture(const Robot& robot, std::mt19937& random) {
  JointVector q(robot.joint_count());
  for (int j = 0; j < robot.joint_count(); ++j) {
    const Joint& joint = robot.joints()[static_cast<std::size_t>(j)];
    const double lower = std::isfinite(joint.lower) ? joint.lower : -kPi;
    const double upper = std::isfinite(joint.upper) ? joint.upper : kPi;
    q[j] = lower + fraction(random) * (upper - lower);
  }
  return q;
}

}  // namespace

SingularityDistance::SingularityDistance(const Robot& robot, SingularityMeasure measure)
    : robot_(robot), measure_(measure), length_(reach(robot)) {
  if (measure != SingularityMeasure::manipulability) return;
  std::mt19937 random(1);
  ChainPose chain;
  double largest = 0;
  for (int k = 0; k < kPostures; ++k) {
    forward_kinematics(robot_, random_posture(robot_, random), chain);
    largest = std::max(largest, manipulability(chain));
  }
  if (largest > 0) largest_ = largest;
}

double SingularityDistance::operator()(const JointVector& q) const {
  ChainPose chain;
  forward_kinematics(robot_, q, chain);
  return measure_ == SingularityMeasure::wrist ? wrist(chain)
                                               : std::min(1.0, manipulability(chain) / largest_);
}

double SingularityDistance::wrist(const ChainPose& chain) const {
  if (chain.joint_count < 3) return 1;
  const auto last = static_cast<std::size_t>(chain.joint_count - 1);
  return chain.axes[last - 2].cross(chain.axes[last]).norm();
}

double SingularityDistance::manipulability(const ChainPose& chain) const {
  Jacobian jacobian = geometric_jacobian(robot_, chain);
  jacobian.topRows<3>() /= length_;
  const double determinant = jacobian.cols() >= 6 ? (jacobian * jacobian.transpose()).determinant()
                                                  : (jacobian.transpose() * jacobian).determinant();
  return std::sqrt(std::max(0.0, determinant));
}

}  // namespace wristwise
