#include "smoothing/rest.hpp"

#include "task/pose_difference.hpp"

namespace wristwise {

bool rests_at_start(const std::vector<double>& times, const std::vector<Pose>& poses,
                    double duration, double position, double angle) {
  std::size_t i = 0;
  while (i < poses.size() && is_near(poses.front(), poses[i], position, angle)) ++i;
  return i == poses.size() || times[i - 1] - times.front() >= duration;
}

bool rests_at_end(const std::vector<double>& times, const std::vector<Pose>& poses, double duration,
                  double position, double angle) {
  std::size_t i = poses.size();
  while (i > 0 && is_near(poses.back(), poses[i - 1], position, angle)) --i;
  return i == 0 || times.back() - times[i] >= duration;
}

}  // namespace wristwise
