#include "timing/weld_speed.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "timing/retiming.hpp"
#include "timing/speed_profile.hpp"

namespace wristwise {

namespace {

/// How a seam is slowed. Stage 2 needs some room below the limits, and ramps that its curve can
/// follow.
struct Slowing {
  double margin;  ///< of the limits
  double spans;   ///< of the time law
};
constexpr std::array<Slowing, 5> kSlowings = {
    {{0.95, 100}, {0.9, 50}, {0.8, 50}, {0.7, 30}, {0.5, 20}}};

Robot without_rate_limits(const Robot& robot) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  Robot::Parts parts = robot.parts();
  for (Joint& joint : parts.joints) {
    joint.max_velocity = joint.max_acceleration = joint.max_jerk = kNone;
  }
  return Robot(std::move(parts));
}

Refined refine_for(const Robot& robot, const Task& task, const RefinementInput& input,
                   const JointPath& seed) {
  return refine({robot, task, input.clearance, input.cost, input.options, input.monitor}, seed);
}

Trajectory slower_law(const RefinementInput& input, const Trajectory& motion, Slowing slowing) {
  const double duration = motion.times().back() - motion.times().front();
  const double spacing = std::min(duration / slowing.spans, 0.4 * input.options.smoothing_time);
  return speed_profile(motion, rate_limits(input.robot), {slowing.margin, spacing, true});
}

/// The postures at the task's waypoints; a motion has rows at knots between them as well.
JointPath at_waypoints(const Task& task, const Trajectory& motion) {
  JointPath path;
  for (const Waypoint& waypoint : task.waypoints) {
    path.times.push_back(waypoint.time);
    path.positions.push_back(motion.evaluate(waypoint.time));
  }
  return path;
}

/// The motion without limits run slower, then refined under them; gentler where that fails.
std::optional<SpeedRefined> slow_down(const RefinementInput& input, const Trajectory& motion,
                                      const MotionCheck& passes) {
  for (const Slowing& slowing : kSlowings) {
    SpeedRefined slowed;
    slowed.law = slower_law(input, motion, slowing);
    slowed.task = run_along(input.task, slowed.law);
    const JointPath seed = at_waypoints_of(slowed.task, at_waypoints(input.task, motion));
    slowed.refined = refine_for(input.robot, slowed.task, input, seed);
    if (passes(slowed.task, slowed.refined.trajectory)) return slowed;
  }
  return std::nullopt;
}

}  // namespace

std::optional<SpeedRefined> refine_at_other_speed(const RefinementInput& input,
                                                  const JointPath& seed,
                                                  const MotionCheck& passes) {
  Refined unlimited = refine_for(without_rate_limits(input.robot), input.task, input, seed);
  if (!unlimited.feasible) return std::nullopt;
  const UniformSlowdown slowdown = uniform_slowdown(unlimited.trajectory, rate_limits(input.robot));
  if (slowdown.factor > 1 && input.task.speed_policy == SpeedPolicy::slow) {
    if (auto slowed = slow_down(input, unlimited.trajectory, passes)) return slowed;
  }
  SpeedRefined result{std::move(unlimited), input.task, {}, {}};
  if (slowdown.factor > 1) result.too_fast = slowdown;
  return result;
}

}  // namespace wristwise
