#pragma once

#include <optional>
#include <string>

#include "kinematics/spherical_wrist.hpp"
#include "wristwise/robot.hpp"

namespace wristwise {

/// The nearest arm with a closed form to a chain, and how far away it is.
struct SphericalWristFit {
  std::optional<SphericalWrist> arm;  ///< nullopt where the chain is not of this form
  double position_misfit = 0;         ///< m, from axes 4, 5, 6 to the wrist centre
  double angle_misfit = 0;            ///< rad, between axes 2 and 3
  std::string failure;                ///< which condition fails, and by how much
};

/// @param misfit m and rad, the most that is accepted
SphericalWristFit fit_spherical_wrist(const Robot& robot, double misfit);

}  // namespace wristwise
