#pragma once

#include "picture/time_series.hpp"
#include "report/shown_motions.hpp"

namespace wristwise {

/// A derivative of one joint's motion, rad or m per s to that power, as it is drawn.
struct JointSeries {
  std::vector<double> times;        ///< s
  std::vector<JointVector> values;  ///< of all joints

  TimeSeries joint(int j, double factor = 1) const;
};

/// Of a curve the derivative itself at about `aim` times or more, knots among them; where the jerk
/// jumps both its values. Of points their divided differences (F12), each in the middle of its
/// points.
/// @param derivative 0 to 3
JointSeries joint_series(const ShownMotion& motion, int derivative, std::size_t aim);

}  // namespace wristwise
