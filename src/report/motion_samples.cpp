#include "report/motion_samples.hpp"

#include <algorithm>
#include <cmath>

#include "wristwise/kinematics.hpp"
#include "wristwise/verification.hpp"

namespace wristwise {

namespace {

constexpr double kTimeTolerance = 1e-6;  // s

/// What the TCP is held to at a time: the waypoint's own frame and box at a waypoint, the seam's
/// place and the box of the stretch between two.
struct Target {
  Pose frame = Pose::Identity();
  std::optional<ToleranceBox> box;  ///< nullopt where no path is prescribed
};

Target target_at(const Task& task, double t) {
  const auto& waypoints = task.waypoints;
  const auto next =
      std::lower_bound(waypoints.begin(), waypoints.end(), t - kTimeTolerance,
                       [](const Waypoint& waypoint, double time) { return waypoint.time < time; });
  if (next == waypoints.end()) return {task.seam.frame_at(t), std::nullopt};
  if (next->time <= t + kTimeTolerance) {
    if (next->joints) return {next->frame, std::nullopt};
    return {next->frame, next->tolerance};
  }
  if (next == waypoints.begin()) return {task.seam.frame_at(t), std::nullopt};
  return {task.seam.frame_at(t),
          task.tolerance_between(static_cast<std::size_t>(next - waypoints.begin()) - 1)};
}

std::size_t interval_of(const std::vector<double>& times, double t) {
  const auto after = std::upper_bound(times.begin(), times.end(), t);
  if (after == times.begin()) return 0;
  return std::min(static_cast<std::size_t>(after - times.begin()) - 1, times.size() - 1);
}

}  // namespace

Vector6 widening_of(const Task& task) {
  const VerificationOptions accepted;
  Vector6 widening;
  widening.head<3>().setConstant(task.between_position + accepted.position_tolerance);
  widening.tail<3>().setConstant(task.between_angle + accepted.angle_tolerance);
  return widening;
}

std::vector<double> sample_times(const std::vector<double>& times, std::size_t aim) {
  if (times.size() < 2) return times;
  const std::size_t stride = (times.size() - 1) / (4 * aim) + 1;
  const double period = (times.back() - times.front()) / static_cast<double>(aim);
  std::vector<double> samples;
  for (std::size_t i = 0; i + 1 < times.size(); i += stride) {
    const double from = times[i], to = times[std::min(i + stride, times.size() - 1)];
    const int parts = std::max(1, static_cast<int>(std::lround((to - from) / period)));
    for (int k = 0; k < parts; ++k) samples.push_back(from + (to - from) * k / parts);
  }
  samples.push_back(times.back());
  return samples;
}

Vector6 tolerance_use(const ToleranceBox& box, const Vector6& deviation, const Vector6& widening) {
  Vector6 use;
  for (int k = 0; k < 6; ++k) {
    const double half = 0.5 * (box.upper[k] - box.lower[k]);
    const double off = std::abs(deviation[k] - 0.5 * (box.upper[k] + box.lower[k]));
    if (box.is_free(k)) {
      use[k] = ToleranceBox::kFree;
    } else if (half > 0 && off <= half) {
      use[k] = off / half;
    } else if (half > 0) {
      use[k] = std::max(1.0, off / (half + widening[k]));
    } else {
      use[k] = off / widening[k];
    }
  }
  return use;
}

MotionSamples sample_tolerance(const Task& task, const Robot& robot, const CheckedMotion& motion,
                               std::size_t aim) {
  MotionSamples samples;
  samples.times = sample_times(motion.times(), aim);
  const Vector6 widening = widening_of(task);
  for (const double t : samples.times) {
    const Pose tcp = tcp_pose(robot, motion.posture(interval_of(motion.times(), t), t));
    const Target target = target_at(task, t);
    samples.seam.push_back(target.box ? target.frame.translation() : tcp.translation());
    samples.boxes.push_back(target.box);
    if (target.box) {
      const Vector6 e = deviation(*target.box, target.frame, tcp);
      samples.deviation.emplace_back(e);
      samples.use.emplace_back(tolerance_use(*target.box, e, widening));
    } else {
      samples.deviation.emplace_back();
      samples.use.emplace_back();
    }
  }
  return samples;
}

MotionSamples sample_motion(const Task& task,
                            const std::shared_ptr<const ClearanceModel>& clearance,
                            const CheckedMotion& motion, std::size_t aim) {
  MotionSamples samples = sample_tolerance(task, clearance->robot(), motion, aim);
  ClearanceChecker checker(clearance);
  for (const double t : samples.times) {
    checker.set_posture(motion.posture(interval_of(motion.times(), t), t));
    samples.nearest.push_back(checker.nearest());
  }
  return samples;
}

}  // namespace wristwise
