#pragma once

#include <memory>
#include <string>
#include <vector>

#include "kinematics/elbow.hpp"
#include "kinematics/six_axes.hpp"
#include "wristwise/inverse_kinematics.hpp"

namespace wristwise {

/// The inverse kinematics of an arm whose axes 1 and 2 meet in one point and whose axes 4, 5 and 6
/// meet in another, in closed form and polished (F78). A seven-axis arm with a spherical shoulder
/// and a spherical wrist is such an arm when a joint of its shoulder is held.
class CrossedShoulder final : public InverseKinematics {
 public:
  /// Null where the chain is no such arm, to the accuracy of rounded numbers in a description.
  static std::shared_ptr<const CrossedShoulder> find(const std::shared_ptr<const Robot>& robot);

  void solve(const Pose& tcp, std::vector<JointVector>& branches) const override;
  std::string description() const override;

 private:
  CrossedShoulder(std::shared_ptr<const Robot> robot, const SixAxes& axes,
                  const Eigen::Vector3d& shoulder, const Eigen::Vector3d& wrist);

  void solve_wrist(const Eigen::Matrix3d& left, JointVector q, const Pose& tcp,
                   std::vector<JointVector>& branches) const;

  std::shared_ptr<const Robot> robot_;
  SixAxes axes_;
  Eigen::Vector3d shoulder_, wrist_;  // at joint zero
  Eigen::Vector3d side_6_;            // perpendicular to axis 6
  Pose tcp_inverse_;                  // at joint zero
  Elbow elbow_;
};

}  // namespace wristwise
