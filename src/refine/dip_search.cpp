#include "refine/dip_search.hpp"

#include <algorithm>
#include <cmath>

namespace wristwise {

namespace {

constexpr int kMostSamples = 400;

double depth_at(const Task& task, std::size_t interval, double time, const JointVector& q,
                ClearanceChecker& checker, double required) {
  checker.set_posture(q);
  double depth = 0;
  if (const auto box = task.tolerance_between(interval)) {
    const Vector6 e = deviation(*box, task.seam.frame_at(time), checker.chain().tcp);
    depth = box_excess(box->widened(task.between_position, task.between_angle), e).maxCoeff();
  }
  if (const auto nearest = checker.nearest(required)) {
    depth = std::max(depth, required - nearest->distance);
  }
  return depth;
}

}  // namespace

std::vector<Dip> find_dips(const Task& task, const Spline& spline, ClearanceChecker& checker,
                           double required, int samples_per_interval, double max_step) {
  std::vector<Dip> dips;
  for (std::size_t i = 0; i + 1 < task.waypoints.size(); ++i) {
    const double t0 = task.waypoints[i].time, t1 = task.waypoints[i + 1].time;
    const double travel =
        (task.waypoints[i + 1].frame.translation() - task.waypoints[i].frame.translation()).norm();
    const int count = std::clamp(static_cast<int>(std::ceil(travel / max_step)),
                                 samples_per_interval, kMostSamples);
    Dip worst{i, t0, 0};
    for (int k = 0; k < count; ++k) {
      const double t = t0 + (k + 0.5) * (t1 - t0) / count;
      const double depth = depth_at(task, i, t, spline.evaluate(t), checker, required);
      if (depth > worst.depth) worst = {i, t, depth};
    }
    if (worst.depth > 0) dips.push_back(worst);
  }
  return dips;
}

}  // namespace wristwise
