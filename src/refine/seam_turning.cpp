#include "refine/seam_turning.hpp"

#include <algorithm>
#include <cmath>

namespace wristwise {

SeamTurning::SeamTurning(const Task& task, double step)
    : times_{task.waypoints.front().time}, turned_{0} {
  Eigen::Vector3d last = Eigen::Vector3d::Zero();
  const Waypoint* from = &task.waypoints.front();
  for (const Waypoint& waypoint : task.waypoints) {
    if (waypoint.time < from->time + step || &waypoint == from) continue;
    const Eigen::Vector3d travel = waypoint.frame.translation() - from->frame.translation();
    times_.push_back(0.5 * (from->time + waypoint.time));
    turned_.push_back(turned_.back() + std::atan2(last.cross(travel).norm(), last.dot(travel)));
    last = travel;
    from = &waypoint;
  }
}

double SeamTurning::until(double t) const {
  const auto after = std::upper_bound(times_.begin(), times_.end(), t);
  if (after == times_.begin()) return 0;
  if (after == times_.end()) return turned_.back();
  const auto i = static_cast<std::size_t>(after - times_.begin());
  const double share = (t - times_[i - 1]) / (times_[i] - times_[i - 1]);
  return turned_[i - 1] + share * (turned_[i] - turned_[i - 1]);
}

}  // namespace wristwise
