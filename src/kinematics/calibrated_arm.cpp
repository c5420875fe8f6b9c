#include "kinematics/calibrated_arm.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "kinematics/pose_polish.hpp"

namespace wristwise {
namespace {

constexpr double kPi = 3.14159265358979323846;
/// Solutions nearer than this (rad) are one: at a double root 1e-12 in the pose is 1e-6 in a joint.
constexpr double kSameSolution = 1e-6;
constexpr int kWristStarts = 8;

bool same_posture(const JointVector& a, const JointVector& b) {
  for (Eigen::Index j = 0; j < a.size(); ++j) {
    if (std::abs(wrap_angle(a[j] - b[j])) > kSameSolution) return false;
  }
  return true;
}

}  // namespace

CalibratedArm::CalibratedArm(std::shared_ptr<const Robot> robot, const SphericalWrist& ideal,
                             double position_misfit, double angle_misfit)
    : robot_(std::move(robot)), ideal_(ideal) {
  const double reach = ideal.upper_arm() + ideal.forearm();
  const double shortest = std::min(ideal.upper_arm(), ideal.forearm());
  misfit_ = 3 * (position_misfit / shortest + angle_misfit);
  margin_.length = std::max(3 * position_misfit + reach * angle_misfit, 1e-12);
  margin_.angle = std::max(misfit_, 1e-12);
  margin_.arm_separation = std::sqrt(misfit_) / 4;
  margin_.wrist_separation = 5 * misfit_;
  margin_.wrist_starts = kWristStarts;
}

void CalibratedArm::solve(const Pose& tcp, std::vector<JointVector>& branches) const {
  std::vector<JointVector> starts;
  ideal_.solve(tcp, margin_, starts);
  const std::size_t first = branches.size();
  for (const JointVector& start : starts) polish(tcp, start, first, branches);
}

void CalibratedArm::polish(const Pose& tcp, JointVector start, std::size_t first,
                           std::vector<JointVector>& branches) const {
  if (!polish_posture(*robot_, tcp, start)) return;
  for (double& angle : start) angle = wrap_angle(angle);
  const bool known =
      std::any_of(branches.begin() + static_cast<std::ptrdiff_t>(first), branches.end(),
                  [&](const JointVector& other) { return same_posture(start, other); });
  if (!known) branches.push_back(std::move(start));
}

}  // namespace wristwise
