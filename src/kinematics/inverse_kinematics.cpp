#include "wristwise/inverse_kinematics.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "kinematics/calibrated_arm.hpp"
#include "kinematics/crossed_shoulder.hpp"
#include "kinematics/reversed_chain.hpp"
#include "kinematics/spherical_wrist_fit.hpp"
#include "kinematics/three_parallel_axes.hpp"
#include "wristwise/error.hpp"
#include "wristwise/numeric_inverse_kinematics.hpp"

namespace wristwise {
namespace {

/// Misfits (m, rad) below this are round-off.
constexpr double kExact = 1e-12;

std::string describe(const SphericalWrist& arm) {
  char text[256];
  std::snprintf(text, sizeof text,
                "spherical wrist, closed form: shoulder %.4g m from axis 1, side offset %.4g m, "
                "upper arm %.4g m, forearm %.4g m, wrist centre to TCP %.4g m",
                arm.shoulder_radius(), std::abs(arm.side_offset()) < 1e-9 ? 0 : arm.side_offset(),
                arm.upper_arm(), arm.forearm(), arm.tool_length());
  return text;
}

std::string describe_misfit(const SphericalWristFit& fit) {
  char text[160];
  std::snprintf(text, sizeof text, "; polished, the chain misses the form by %.3g mm and %.3g deg",
                1e3 * fit.position_misfit, fit.angle_misfit * 57.29577951308232);
  return text;
}

class ClosedForm : public InverseKinematics {
 public:
  ClosedForm(SphericalWrist arm, std::string description)
      : arm_(std::move(arm)), description_(std::move(description)) {}

  void solve(const Pose& tcp, std::vector<JointVector>& branches) const override {
    branches.clear();
    arm_.solve(tcp, WorkspaceMargin{}, branches);
  }
  std::string description() const override { return description_; }

 private:
  SphericalWrist arm_;
  std::string description_;
};

class PolishedClosedForm : public InverseKinematics {
 public:
  PolishedClosedForm(CalibratedArm arm, std::string description)
      : arm_(std::move(arm)), description_(std::move(description)) {}

  void solve(const Pose& tcp, std::vector<JointVector>& branches) const override {
    branches.clear();
    arm_.solve(tcp, branches);
  }
  std::string description() const override { return description_; }

 private:
  CalibratedArm arm_;
  std::string description_;
};

/// Of the chain as it is, not of the reversed one.
InverseKinematicsFound find_form(const std::shared_ptr<const Robot>& robot, double misfit) {
  const SphericalWristFit fit = fit_spherical_wrist(*robot, std::max(misfit, kExact));
  if (!fit.arm) {
    if (const auto arm = CrossedShoulder::find(robot)) return {arm, arm->description()};
    if (const auto arm = ThreeParallelAxes::find(robot)) return {arm, arm->description()};
    return {nullptr, "no closed form: " + fit.failure};
  }
  InverseKinematicsFound found;
  found.description = describe(*fit.arm);
  if (fit.position_misfit <= kExact && fit.angle_misfit <= kExact) {
    found.solver = std::make_shared<ClosedForm>(*fit.arm, found.description);
    return found;
  }
  found.description += describe_misfit(fit);
  found.solver = std::make_shared<PolishedClosedForm>(
      CalibratedArm(robot, *fit.arm, fit.position_misfit, fit.angle_misfit), found.description);
  return found;
}

}  // namespace

InverseKinematicsFound find_closed_form(std::shared_ptr<const Robot> robot, double misfit) {
  if (!robot) throw InvalidInput("find_closed_form", "no robot");
  if (!(misfit >= 0)) {
    throw InvalidInput("find_closed_form", "misfit is " + std::to_string(misfit),
                       "m and rad, zero or more");
  }
  InverseKinematicsFound found = find_form(robot, misfit);
  if (found.solver) return found;
  const auto reversed = std::make_shared<const Robot>(reversed_chain(*robot));
  const InverseKinematicsFound of_reversed = find_form(reversed, misfit);
  if (!of_reversed.solver) return found;
  const auto solver = std::make_shared<ReversedInverseKinematics>(of_reversed.solver);
  return {solver, solver->description()};
}

InverseKinematicsFound find_inverse_kinematics(std::shared_ptr<const Robot> robot, double misfit) {
  InverseKinematicsFound found = find_closed_form(robot, misfit);
  if (found.solver) return found;
  const auto solver = std::make_shared<NumericInverseKinematics>(std::move(robot));
  return {solver, solver->description() + " (" + found.description + ")"};
}

}  // namespace wristwise
