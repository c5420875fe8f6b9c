#pragma once

#include <memory>

#include "wristwise/inverse_kinematics.hpp"
#include "wristwise/robot.hpp"

namespace wristwise {

/// The same joints from the TCP to the base: its TCP pose is the inverse of the robot's, its
/// postures are the robot's in reverse order. Without links.
Robot reversed_chain(const Robot& robot);

/// The inverse kinematics of a robot by that of its reversed chain: of an arm that holds the part
/// under a torch that stands still.
class ReversedInverseKinematics : public InverseKinematics {
 public:
  explicit ReversedInverseKinematics(std::shared_ptr<const InverseKinematics> of_reversed)
      : of_reversed_(std::move(of_reversed)) {}

  void solve(const Pose& tcp, std::vector<JointVector>& branches) const override;
  std::string description() const override;

 private:
  std::shared_ptr<const InverseKinematics> of_reversed_;
};

}  // namespace wristwise
