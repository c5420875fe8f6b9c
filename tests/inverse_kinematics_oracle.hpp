#pragma once

// What solutions of the inverse kinematics have to be, and a search that finds them without it.

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "random_arm.hpp"
#include "wristwise/inverse_kinematics.hpp"
#include "wristwise/kinematics.hpp"

namespace wristwise::test {

constexpr double kPoseTolerance = 1e-11;  // m and entries of the rotation

inline double pose_error(const Pose& a, const Pose& b) {
  return std::max((a.translation() - b.translation()).norm(), (a.linear() - b.linear()).norm());
}

inline double angle_distance(const JointVector& a, const JointVector& b) {
  double distance = 0;
  for (Eigen::Index j = 0; j < a.size(); ++j) {
    distance = std::max(distance, std::abs(std::remainder(a[j] - b[j], 2 * Dice::kPi)));
  }
  return distance;
}

inline bool contains(const std::vector<JointVector>& branches, const JointVector& q,
                     double tolerance) {
  return std::any_of(branches.begin(), branches.end(), [&](const JointVector& branch) {
    return angle_distance(branch, q) < tolerance;
  });
}

/// Every branch meets the pose, is in (-pi, pi], and is there once.
inline void expect_valid(const Robot& robot, const Pose& tcp,
                         const std::vector<JointVector>& branches) {
  for (std::size_t i = 0; i < branches.size(); ++i) {
    ASSERT_EQ(branches[i].size(), 6);
    EXPECT_LT(pose_error(tcp_pose(robot, branches[i]), tcp), kPoseTolerance)
        << branches[i].transpose();
    EXPECT_GT(branches[i].minCoeff(), -Dice::kPi);
    EXPECT_LE(branches[i].maxCoeff(), Dice::kPi);
    for (std::size_t k = 0; k < i; ++k) {
      EXPECT_GT(angle_distance(branches[i], branches[k]), 1e-9);
    }
  }
}

inline std::shared_ptr<const InverseKinematics> solver_of(
    const std::shared_ptr<const Robot>& robot) {
  const InverseKinematicsFound found = find_inverse_kinematics(robot);
  EXPECT_NE(found.solver, nullptr) << found.description;
  return found.solver;
}

/// Newton's method with damping and numeric derivatives from many starts.
inline std::vector<JointVector> numeric_solutions(const Robot& robot, const Pose& target,
                                                  Dice& dice, int starts) {
  using Residual = Eigen::Matrix<double, 12, 1>;
  const auto residual = [&](const JointVector& q) {
    const Pose tcp = tcp_pose(robot, q);
    Residual r;
    r.head<3>() = tcp.translation() - target.translation();
    r.tail<9>() = Eigen::Map<const Eigen::Matrix<double, 9, 1>>(
        Eigen::Matrix3d(tcp.linear() - target.linear()).data());
    return r;
  };
  std::vector<JointVector> solutions;
  for (int start = 0; start < starts; ++start) {
    JointVector q = dice.posture();
    for (int step = 0; step < 60 && residual(q).norm() > 1e-12; ++step) {
      Eigen::Matrix<double, 12, 6> slope;
      for (int j = 0; j < 6; ++j) {
        JointVector after = q, before = q;
        after[j] += 1e-6;
        before[j] -= 1e-6;
        slope.col(j) = (residual(after) - residual(before)) / 2e-6;
      }
      Eigen::Matrix<double, 6, 1> move = slope.colPivHouseholderQr().solve(residual(q));
      const double longest = move.cwiseAbs().maxCoeff();
      if (longest > 0.5) move *= 0.5 / longest;
      q -= move;
    }
    if (residual(q).norm() < 1e-9 && !contains(solutions, q, 1e-5)) solutions.push_back(q);
  }
  return solutions;
}

}  // namespace wristwise::test
