#include "smoothing/chord_bound.hpp"

#include <algorithm>
#include <cmath>

namespace wristwise {

ChordBound::ChordBound(const Robot& robot, const JointPath& path)
    : turns_(robot.joint_count()), reach_(robot.joint_count()) {
  JointVector farthest = JointVector::Zero(robot.joint_count());
  for (const JointVector& q : path.positions) farthest = farthest.cwiseMax(q.cwiseAbs());
  double reach = robot.tcp().translation().norm();
  for (int j = robot.joint_count() - 1; j >= 0; --j) {
    const Joint& joint = robot.joints()[static_cast<std::size_t>(j)];
    const bool slides = joint.type == JointType::prismatic;
    turns_[j] = slides ? 0 : 1;
    reach_[j] = slides ? 1 : reach;
    reach += joint.origin.translation().norm() + (slides ? farthest[j] : 0);
  }
}

// (F52) p'' = sum_jk dq_j dq_k H_jk with |H_jk| <= reach of the joint nearer the TCP, zero where
// the joint nearer the base slides; and |f - line| <= max |f''| / 8.
double ChordBound::position(const JointVector& step) const {
  double curvature = 0;
  for (int j = 0; j < step.size(); ++j) {
    double towards_tcp = 0.5 * std::abs(step[j]) * reach_[j];
    for (int k = j + 1; k < step.size(); ++k) towards_tcp += std::abs(step[k]) * reach_[k];
    curvature += 2 * turns_[j] * std::abs(step[j]) * towards_tcp;
  }
  return curvature / 8;
}

// (F52) omega' = sum_{j<k} dq_j dq_k a_j x a_k; the angle to the turn at a constant rate is at most
// |omega'| / 4.
double ChordBound::angle(const JointVector& step) const {
  double before = 0, change = 0;
  for (int k = 0; k < step.size(); ++k) {
    const double turn = turns_[k] * std::abs(step[k]);
    change += before * turn;
    before += turn;
  }
  return change / 4;
}

double ChordBound::pieces(const JointVector& step, double position_deviation,
                          double angle_deviation) const {
  const double turning = turns_.dot(step.cwiseAbs());
  return std::ceil(std::max({1.0, turning, std::sqrt(position(step) / position_deviation),
                             std::sqrt(angle(step) / angle_deviation)}));
}

}  // namespace wristwise
