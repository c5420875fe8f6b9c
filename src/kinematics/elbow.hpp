#pragma once

#include "kinematics/turns_onto.hpp"

namespace wristwise {

/// A joint that sets the distance between a point before it and one behind it (F78).
class Elbow {
 public:
  /// An axis by a point and its unit direction; `shoulder` and `wrist` at joint zero.
  Elbow(const Eigen::Vector3d& point, const Eigen::Vector3d& direction,
        const Eigen::Vector3d& shoulder, const Eigen::Vector3d& wrist);

  /// The angles (rad) at which shoulder and wrist have this distance; out of reach by no more than
  /// `slack` (of the cosine) is touching.
  UpToTwo<double> angles(double squared_distance, double slack) const;

  double upper_arm() const { return upper_arm_; }  ///< m, from the shoulder to the axis
  double forearm() const { return forearm_; }      ///< m, from the axis to the wrist

 private:
  double upper_arm_ = 0, forearm_ = 0;
  double along_ = 0;  // m, from shoulder to wrist along the axis
  double zero_ = 0;   // rad, where the wrist is nearest to the shoulder
};

}  // namespace wristwise
