#pragma once

#include <memory>
#include <string>
#include <vector>

#include "kinematics/joint_samples.hpp"
#include "wristwise/inverse_kinematics.hpp"

namespace wristwise {

/// The inverse kinematics of a chain with joints to spare: they are sampled, and the rest is solved
/// for each combination of samples (F61).
class RedundantInverseKinematics : public InverseKinematics {
 public:
  /// @param sampled by increasing index, none empty; not all joints
  /// @param finder of the solvers for what is left of the chain
  /// @return a null solver, with the finder's reason, where it has none for some combination
  static InverseKinematicsFound find(const std::shared_ptr<const Robot>& robot,
                                     std::vector<SampledJoint> sampled,
                                     const InverseKinematicsFinder& finder);

  void solve(const Pose& tcp, std::vector<JointVector>& branches) const override;
  void solve_beside(const Pose& tcp, const JointVector& posture,
                    std::vector<JointVector>& branches) const override;
  std::size_t samples() const override {
    return first_ends_.size() * middles_.size() * last_ends_.size();
  }
  std::string description() const override { return description_; }

 private:
  /// Samples of the joints at one end of the chain, with what they do to the TCP.
  struct End {
    JointVector posture;  ///< the chain's, with their values
    Pose correction;
  };
  /// Samples of the joints between those that are solved for, with the solver that is left.
  struct Middle {
    JointVector posture;
    std::shared_ptr<const InverseKinematics> solver;
  };

  RedundantInverseKinematics(const std::shared_ptr<const Robot>& robot,
                             std::vector<SampledJoint> sampled, InverseKinematicsFinder finder);

  bool is_before(int joint) const { return joint < solved_.front(); }
  bool is_behind(int joint) const { return joint > solved_.back(); }
  bool is_between(int joint) const { return !is_before(joint) && !is_behind(joint); }
  Pose before(const JointVector& posture) const;
  Pose behind(const JointVector& posture) const;
  End first_end(JointVector posture) const;
  End last_end(JointVector posture) const;
  InverseKinematicsFound solver_with(const JointVector& posture) const;
  template <class Accept>
  std::vector<JointVector> combinations(const Accept& accept) const;
  void append(const Pose& tcp, const End& first, const End& last, const Middle& middle,
              std::vector<JointVector>& scratch, std::vector<JointVector>& branches) const;

  std::shared_ptr<const Robot> robot_;
  std::vector<SampledJoint> sampled_;
  InverseKinematicsFinder finder_;
  std::vector<int> held_, solved_;  ///< joints
  JointVector first_;               ///< the first sample of each held joint
  std::vector<End> first_ends_, last_ends_;
  std::vector<Middle> middles_;
  std::string description_;
};

}  // namespace wristwise
