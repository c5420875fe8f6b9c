#include "kinematics/solution_set.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wristwise {

double posture_distance(const Robot& robot, const JointVector& a, const JointVector& b,
                        Eigen::Index from, Eigen::Index to) {
  double largest = 0;
  for (Eigen::Index j = from; j < to; ++j) {
    const bool slides = robot.joints()[static_cast<std::size_t>(j)].type == JointType::prismatic;
    largest = std::max(largest, std::abs(slides ? a[j] - b[j] : wrap_angle(a[j] - b[j])));
  }
  return largest;
}

void SolutionSet::turn_home(JointVector& q) const {
  for (Eigen::Index j = 0; j < q.size(); ++j) {
    if (robot_.joints()[static_cast<std::size_t>(j)].type != JointType::prismatic)
      q[j] = wrap_angle(q[j]);
  }
}

double SolutionSet::distance_to_nearest(const JointVector& q) const {
  double nearest = std::numeric_limits<double>::infinity();
  for (const JointVector& other : solutions_)
    nearest = std::min(nearest, posture_distance(robot_, q, other, 0, q.size()));
  return nearest;
}

}  // namespace wristwise
