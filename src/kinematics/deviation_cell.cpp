#include "kinematics/deviation_cell.hpp"

#include <algorithm>

namespace wristwise {

Vector6 DeviationCell::middle() const {
  Vector6 middle;
  for (int k = 0; k < 6; ++k) middle[k] = is_free(k) ? 0 : 0.5 * (lower[k] + upper[k]);
  return middle;
}

Vector6 DeviationCell::measure(const Pose& tcp) const {
  Vector6 e = deviation(box, path_frame, tcp);
  const Vector6 centre = middle();
  for (int k = 3; k < 6; ++k) e[k] = centre[k] + wrap_angle(e[k] - centre[k]);
  return e;
}

Vector6 DeviationCell::measure(const Robot& robot, const JointVector& q, Jacobian& jacobian) const {
  ChainPose chain;
  forward_kinematics(robot, q, chain);
  jacobian = deviation_jacobian(box, path_frame, chain.tcp, geometric_jacobian(robot, chain));
  return measure(chain.tcp);
}

Vector6 DeviationCell::outside(const Vector6& e) const {
  return e - e.cwiseMax(lower).cwiseMin(upper);
}

}  // namespace wristwise
