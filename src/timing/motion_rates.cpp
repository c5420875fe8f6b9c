#include "timing/motion_rates.hpp"

#include <utility>
#include <vector>

namespace wristwise {

Rates rates_at(const Trajectory& motion, double t) {
  Rates rates(motion.positions().front().size(), 3);
  for (int k = 0; k < 3; ++k) rates.col(k) = motion.evaluate(t, k + 1);
  return rates;
}

Rates rate_limits(const Robot& robot) {
  Rates limits(robot.joint_count(), 3);
  limits.col(0) = robot.velocity_limits();
  limits.col(1) = robot.acceleration_limits();
  limits.col(2) = robot.jerk_limits();
  return limits;
}

Rates along_law(const Rates& motion, const Eigen::Vector3d& law) {
  Rates rates(motion.rows(), 3);
  rates.col(0) = motion.col(0) * law[0];
  rates.col(1) = motion.col(1) * (law[0] * law[0]) + motion.col(0) * law[1];
  rates.col(2) = motion.col(2) * (law[0] * law[0] * law[0]) +
                 motion.col(1) * (3 * law[0] * law[1]) + motion.col(0) * law[2];
  return rates;
}

Trajectory run_along(const Trajectory& outer, const Trajectory& inner) {
  std::vector<JointVector> positions, velocities, accelerations;
  for (std::size_t i = 0; i < inner.times().size(); ++i) {
    const double tau = inner.positions()[i][0];
    const Eigen::Vector3d law(inner.velocities()[i][0], inner.accelerations()[i][0], 0);
    const Rates rates = along_law(rates_at(outer, tau), law);
    positions.push_back(outer.evaluate(tau));
    velocities.emplace_back(rates.col(0));
    accelerations.emplace_back(rates.col(1));
  }
  return {inner.times(), std::move(positions), std::move(velocities), std::move(accelerations)};
}

}  // namespace wristwise
