#pragma once

#include <memory>
#include <string>
#include <vector>

#include "wristwise/inverse_kinematics.hpp"
#include "wristwise/tolerance.hpp"
#include "wristwise/visibility.hpp"

namespace WRISTWISE_PUBLIC wristwise {

class NumericSearch;

/// How many starts the numeric inverse kinematics makes, and what it takes for two solutions.
struct NumericIkOptions {
  int postures = 10000;        ///< of the table of starts, at most
  int neighbours = 128;        ///< postures of the table that are looked at for a pose
  int vain_starts = 32;        ///< in a row, without a new solution, after which the search ends
  double separation = 0.3;     ///< rad or m; of a continuum of solutions, those that differ by less
                               ///< in every joint are one
  int most_of_continuum = 32;  ///< solutions, where there is a continuum of them
  int box_poses = 24;          ///< poses of a tolerance box from which postures are led into it
};

/// Inverse kinematics of any chain, without a closed form: damped least squares from the postures
/// of a table that come nearest to the pose (F71, F72). What is found for a pose depends on nothing
/// but the robot, the options and that pose. Thread-safe.
class NumericInverseKinematics final : public InverseKinematics {
 public:
  /// @throws InvalidInput for no robot or options that are not positive
  explicit NumericInverseKinematics(std::shared_ptr<const Robot> robot,
                                    const NumericIkOptions& options = {});
  ~NumericInverseKinematics() override;

  /// The distinct solutions for one pose, to 1e-10 m and rad; for a chain that cannot move its TCP
  /// in all six directions those of poses that it can reach, to 1e-9 m and rad. Prismatic joints
  /// keep their limits. A chain with more than six joints has a continuum of solutions: of that,
  /// postures inside the joint limits are given, `separation` apart.
  void solve(const Pose& tcp, std::vector<JointVector>& branches) const override;

  bool meets_every_pose() const override;
  void solve_near(const ToleranceSample& sample, std::vector<JointVector>& branches) const override;

  /// Distinct postures inside the joint limits whose TCP is anywhere in a tolerance box, to 1e-10
  /// (as above: 1e-9) m and rad: from each start the nearest such posture, by NLopt (F73). Where
  /// the box leaves a continuum they are `separation` apart. Revolute joints in (-pi, pi].
  /// @throws InvalidInput where the box is not valid
  void solve_in_box(const ToleranceBox& box, const Pose& path_frame,
                    std::vector<JointVector>& postures) const;

  std::string description() const override;

 private:
  std::unique_ptr<const NumericSearch> search_;
};

}  // namespace wristwise
