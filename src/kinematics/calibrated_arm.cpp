#include "kinematics/calibrated_arm.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "kinematics/pose_polish.hpp"

namespace wristwise {
namespace {

constexpr int kWristStarts = 8;

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
  for (const JointVector& start : starts) append_polished(*robot_, tcp, start, first, branches);
}

}  // namespace wristwise
