#pragma once

#include <memory>
#include <string>
#include <vector>

#include "wristwise/robot.hpp"
#include "wristwise/tolerance.hpp"

namespace wristwise {

/// A sample of a tolerance box, and the part of the box that it stands for.
struct ToleranceSample {
  ToleranceBox box;
  Pose path_frame = Pose::Identity();
  Vector6 deviation = Vector6::Zero();                       ///< m, rad
  Vector6 lower = Vector6::Zero(), upper = Vector6::Zero();  ///< of the part; m, rad
};

/// All postures that bring the TCP to a pose. Thread-safe; implement it to bring your own.
class InverseKinematics {
 public:
  virtual ~InverseKinematics() = default;

  /// Clears `branches` and fills it with every distinct solution, revolute joints in (-pi, pi],
  /// *whether or not it is inside the joint limits*, in a fixed order. Empty: out of reach.
  virtual void solve(const Pose& tcp, std::vector<JointVector>& branches) const = 0;

  /// False for a chain that can't move its TCP in all six directions: few samples of a tolerance
  /// box are poses that it can reach, so that stage 1 asks for solve_near.
  virtual bool meets_every_pose() const { return true; }

  /// As solve, for the sample; where that is out of reach, for any pose in the part of the box that
  /// it stands for. By default the sample alone.
  virtual void solve_near(const ToleranceSample& sample, std::vector<JointVector>& branches) const {
    solve(pose_at_deviation(sample.box, sample.path_frame, sample.deviation), branches);
  }

  /// One line for people: what was recognised.
  virtual std::string description() const = 0;
};

struct InverseKinematicsFound {
  std::shared_ptr<const InverseKinematics> solver;  ///< not null
  std::string description;  ///< what was found, and why there is no closed form where there is none
};

/// Finds the closed form for a six-axis arm with a spherical wrist from the geometry of the chain:
/// axes 4, 5, 6 meet in a point and axes 2, 3 are parallel, in any frame convention, with any axis
/// signs and offsets. A chain that misses this by up to `misfit` (m; and rad) is solved in closed
/// form and polished by Newton steps on the true chain (F7). Any other chain is solved numerically
/// (numeric_inverse_kinematics.hpp).
InverseKinematicsFound find_inverse_kinematics(std::shared_ptr<const Robot> robot,
                                               double misfit = 1e-3);

enum class Turns { all, principal };

/// Appends every copy of `branch` inside the joint limits, shifted by whole turns of its revolute
/// joints (Turns::all), or the one in (-pi, pi] (Turns::principal). Limits are kept to 1e-12.
/// @return the number appended, and in `limiting_joint` (may be null) the first joint with no copy
/// inside its limits, -1 if none.
int append_turns(const Robot& robot, const JointVector& branch, Turns turns,
                 std::vector<JointVector>& postures, int* limiting_joint = nullptr);

}  // namespace wristwise
