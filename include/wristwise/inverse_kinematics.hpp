#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "wristwise/robot.hpp"
#include "wristwise/tolerance.hpp"
#include "wristwise/visibility.hpp"

namespace WRISTWISE_PUBLIC wristwise {

/// A sample of a tolerance box, and the part of the box that it stands for.
struct ToleranceSample {
  ToleranceBox box;                     ///< of the waypoint
  Pose path_frame = Pose::Identity();   ///< of the waypoint, in the base frame
  Vector6 deviation = Vector6::Zero();  ///< of the sample from the path frame; m, rad
  Vector6 lower = Vector6::Zero();      ///< of the part, from the path frame; m, rad
  Vector6 upper = Vector6::Zero();      ///< likewise
};

/// All postures that bring the TCP to a pose. Thread-safe; implement it to bring your own.
class InverseKinematics {
 public:
  virtual ~InverseKinematics() = default;

  /// Clears `branches` and fills it with every distinct solution, revolute joints in (-pi, pi],
  /// *whether or not it is inside the joint limits*, in a fixed order. Empty: out of reach.
  /// Of a chain with joints to spare: those for each sample of the joints that are sampled.
  /// @param tcp the TCP in the base frame, m
  /// @param branches n values each, rad or m
  virtual void solve(const Pose& tcp, std::vector<JointVector>& branches) const = 0;

  /// The same, but where joints are sampled, with their values of this posture in place of the
  /// samples.
  virtual void solve_beside(const Pose& tcp, const JointVector& /*posture*/,
                            std::vector<JointVector>& branches) const {
    solve(tcp, branches);
  }

  /// Combinations of samples of joints to spare, for each of which a pose is solved.
  virtual std::size_t samples() const { return 1; }

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

/// The outcome of the search for a solver.
struct InverseKinematicsFound {
  std::shared_ptr<const InverseKinematics> solver;  ///< null where nothing fits
  std::string description;                          ///< what was found, or why nothing fits
};

/// Finds the closed form of a six-axis arm from the geometry of the chain, in any frame convention,
/// with any axis signs and offsets:
/// - axes 4, 5, 6 meet in a point and axes 2, 3 are parallel. A chain that misses this by up to
///   `misfit` (m; and rad) is solved in closed form and polished by Newton steps on the true chain
///   (F7);
/// - axes 4, 5, 6 meet in a point and axes 1, 2 in another (F78);
/// - axes 2, 3, 4 are parallel and axes 5, 6 meet in a point (F79).
/// An arm that the chain passes backwards, as it holds the part, is recognised as well.
InverseKinematicsFound find_closed_form(std::shared_ptr<const Robot> robot, double misfit = 1e-3);

/// The closed form, or else the numeric solver of any chain (numeric_inverse_kinematics.hpp), with
/// the reason. Never null.
InverseKinematicsFound find_inverse_kinematics(std::shared_ptr<const Robot> robot,
                                               double misfit = 1e-3);

/// Finds a solver for a chain, such as find_inverse_kinematics.
using InverseKinematicsFinder =
    std::function<InverseKinematicsFound(const std::shared_ptr<const Robot>&)>;

/// Sampling steps (rad or m) of joints by name; 0: the default.
using JointSteps = std::map<std::string, double>;

/// For chains with joints to spare (rail, torso, seventh axis, positioner): as many joints as
/// exceed six are sampled, and one of the finders solves the rest. The joints that `steps` names
/// are sampled in any case. The others are chosen such that, by falling weight, an early finder
/// solves the rest; the rest is one piece of the chain, so that one solver serves all samples; as
/// many prismatic joints, and then the first ones of the chain, are sampled. Without joints to
/// sample it is the first solver found.
/// @param robot the chain
/// @param steps sampling steps of joints, by name
/// @param finders the preferred ones first; empty: find_closed_form, and where it finds nothing the
/// numeric solver, of the whole chain unless `steps` names joints
///
/// Samples of a joint: its range cut into the fewest equal intervals not longer than the step, both
/// ends included; of one that can turn round, -pi + k 2 pi / n. Default steps are 0.1 m and 10 deg;
/// where that makes more than 100 combinations larger ones in proportion, but three samples or
/// more.
/// @return a null solver where no finder has one, or more than three joints were to be sampled
/// @throws InvalidInput for an unknown joint, a step that is negative or no number, or more than
/// 100,000 combinations.
InverseKinematicsFound find_redundant_inverse_kinematics(
    const std::shared_ptr<const Robot>& robot, const JointSteps& steps = {},
    const std::vector<InverseKinematicsFinder>& finders = {});

/// Which of the postures that differ by whole turns of joints are taken.
enum class Turns {
  all,        ///< every one inside the joint limits
  principal,  ///< the one in (-pi, pi]
};

/// Appends every copy of `branch` inside the joint limits, shifted by whole turns of its revolute
/// joints (Turns::all), or the one in (-pi, pi] (Turns::principal). Limits are kept to 1e-12.
/// @return the number appended, and in `limiting_joint` (may be null) the first joint with no copy
/// inside its limits, -1 if none.
int append_turns(const Robot& robot, const JointVector& branch, Turns turns,
                 std::vector<JointVector>& postures, int* limiting_joint = nullptr);

}  // namespace wristwise
