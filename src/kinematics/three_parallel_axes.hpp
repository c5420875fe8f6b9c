#pragma once

#include <memory>
#include <string>
#include <vector>

#include "kinematics/elbow.hpp"
#include "kinematics/six_axes.hpp"
#include "wristwise/inverse_kinematics.hpp"

namespace wristwise {

/// The inverse kinematics of an arm whose axes 2, 3 and 4 are parallel and whose axes 5 and 6 meet,
/// such as those of Universal Robots, in closed form and polished (F79).
class ThreeParallelAxes final : public InverseKinematics {
 public:
  /// Null where the chain is no such arm, to the accuracy of rounded numbers in a description.
  static std::shared_ptr<const ThreeParallelAxes> find(const std::shared_ptr<const Robot>& robot);

  void solve(const Pose& tcp, std::vector<JointVector>& branches) const override;
  std::string description() const override;

 private:
  ThreeParallelAxes(std::shared_ptr<const Robot> robot, const SixAxes& axes,
                    const Eigen::Vector3d& wrist);

  void solve_wrist(const Pose& left, double shoulder, const Pose& tcp,
                   std::vector<JointVector>& branches) const;
  void solve_plane(const Pose& left, double turned, JointVector q, const Pose& tcp,
                   std::vector<JointVector>& branches) const;

  std::shared_ptr<const Robot> robot_;
  SixAxes axes_;
  Eigen::Vector3d wrist_;   // where axes 5 and 6 meet, at joint zero
  Eigen::Vector3d side_6_;  // perpendicular to axis 6
  Pose tcp_inverse_;        // at joint zero
  Elbow elbow_;
  double sign_3_ = 1, sign_4_ = 1;  // of axes 3 and 4 along axis 2
};

}  // namespace wristwise
