#pragma once

#include <cmath>

#include "wristwise/inverse_kinematics.hpp"

#include "gantry.hpp"

namespace wristwise::test::gantry {

/// The one posture of the gantry for a pose that turns about x only.
class ExactIk final : public InverseKinematics {
 public:
  void solve(const Pose& tcp, std::vector<JointVector>& branches) const override {
    const Eigen::Vector3d p = tcp.translation();
    const double tilt = std::atan2(tcp.linear()(2, 1), tcp.linear()(1, 1));
    branches.assign(1, posture(p.x(), p.y(), p.z(), tilt));
  }
  std::string description() const override { return "gantry"; }
};

}  // namespace wristwise::test::gantry
