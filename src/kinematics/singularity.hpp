#pragma once

#include "wristwise/kinematics.hpp"
#include "wristwise/options.hpp"

namespace wristwise {

/// Distance of a posture from a singular one, 0 to 1 (F20).
class SingularityDistance {
 public:
  SingularityDistance(const Robot& robot, SingularityMeasure measure);

  double operator()(const JointVector& q) const;

 private:
  double wrist(const ChainPose& chain) const;
  double manipulability(const ChainPose& chain) const;

  const Robot& robot_;
  SingularityMeasure measure_;
  double length_ = 1;   ///< m, that makes a translation count as much as a turn
  double largest_ = 1;  ///< manipulability in the workspace
};

}  // namespace wristwise
