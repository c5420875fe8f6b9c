#pragma once

#include <vector>

#include "wristwise/inverse_kinematics.hpp"
#include "wristwise/robot.hpp"

namespace wristwise {

/// A joint of the chain, by index, with the values at which it is sampled: rad in (-pi, pi], or m.
struct SampledJoint {
  int joint = 0;
  std::vector<double> values;
};

/// The samples of the joints `joints` (by index), see find_redundant_inverse_kinematics.
/// @throws InvalidInput for more than 100,000 combinations
std::vector<SampledJoint> sample_joints(const Robot& robot, const std::vector<int>& joints,
                                        const JointSteps& steps);

}  // namespace wristwise
