#pragma once

#include <memory>
#include <vector>

#include "kinematics/spherical_wrist.hpp"
#include "wristwise/robot.hpp"

namespace wristwise {

/// The inverse kinematics of a chain that misses the closed form by a little, as arms do after
/// calibration: the closed form of the nearest ideal arm, then Newton steps on the chain itself.
class CalibratedArm {
 public:
  /// Misfits in m and rad.
  CalibratedArm(std::shared_ptr<const Robot> robot, const SphericalWrist& ideal,
                double position_misfit, double angle_misfit);

  /// Appends the distinct solutions. Next to a wrist singularity, where the ideal arm says little
  /// about joint 4, several starts are tried.
  void solve(const Pose& tcp, std::vector<JointVector>& branches) const;

 private:
  std::shared_ptr<const Robot> robot_;
  SphericalWrist ideal_;
  double misfit_ = 0;  // rad, of the wrist's orientation
  WorkspaceMargin margin_;
};

}  // namespace wristwise
