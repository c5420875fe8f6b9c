#pragma once

#include <string>
#include <utility>

#include "wristwise/joints.hpp"
#include "wristwise/visibility.hpp"

namespace WRISTWISE_PUBLIC wristwise {

class Robot;

/// A range for each joint, rad or m, in chain order. A joint with lower == upper has one value.
struct JointBox {
  JointVector lower;  ///< n values, rad or m; -infinity: the joint's own limit
  JointVector upper;  ///< n values, rad or m; +infinity: the joint's own limit

  JointBox() = default;                                                     ///< of no joints
  JointBox(const JointVector& posture) : lower(posture), upper(posture) {}  ///< exactly this one
  /// Each joint between its bounds; not validated, see cut_to_limits.
  JointBox(JointVector lower_bounds, JointVector upper_bounds)
      : lower(std::move(lower_bounds)), upper(std::move(upper_bounds)) {}

  /// The middle of every range; the posture itself where the box holds only one.
  JointVector nominal() const;
};

/// The part of the box that is inside the joint limits.
/// @throws InvalidInput for another number of joints than the robot's, NaN, lower > upper, a joint
/// without a value inside its limits, or one that neither the box nor a limit bounds. `where` names
/// the input in the message.
JointBox cut_to_limits(const Robot& robot, const JointBox& box, const std::string& where);

}  // namespace wristwise
