#include "timing/weld_speed.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "timing/retiming.hpp"
#include "timing/speed_profile.hpp"

namespace wristwise {

namespace {

constexpr double kFastestSpans = 200;  // of a profile; finer ramps leave the curve no room
/// Of the limits, for each time that the seam is slowed: stage 2 needs some room below them.
constexpr std::array<double, 6> kMargins = {0.95, 0.9, 0.85, 0.8, 0.7, 0.6};

Robot without_rate_limits(const Robot& robot) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  Robot::Parts parts{robot.name(),  robot.base_link(), robot.tip_link(),       robot.joints(),
                     robot.links(), robot.tcp(),       robot.adjacent_links(), robot.warnings()};
  for (Joint& joint : parts.joints) {
    joint.max_velocity = joint.max_acceleration = joint.max_jerk = kNone;
  }
  return Robot(std::move(parts));
}

class WeldSpeed {
 public:
  WeldSpeed(const RefinementInput& input, const JointPath& seed)
      : input_(input),
        unlimited_(without_rate_limits(input.robot)),
        limits_(rate_limits(input.robot)),
        path_(seed) {
    result_.task = input.task;
  }

  SpeedRefined run() {
    const bool slow = input_.task.speed_policy == SpeedPolicy::slow;
    for (std::size_t round = 0; !meets_limits(); ++round) {
      if (!result_.too_fast || !slow || round == kMargins.size()) break;
      slow_down(kMargins[round]);
    }
    return std::move(result_);
  }

 private:
  Refined refine_for(const Robot& robot) const {
    const RefinementInput input{robot,       result_.task,   input_.clearance,
                                input_.cost, input_.options, input_.monitor};
    return refine(input, path_);
  }

  /// Tries the limits; where that fails, says whether they are what is in the way.
  bool meets_limits() {
    result_.too_fast.reset();
    result_.refined = refine_for(input_.robot);
    if (result_.refined.feasible) return true;
    Refined free = refine_for(unlimited_);
    if (!free.feasible) return false;
    const UniformSlowdown slowdown = uniform_slowdown(free.trajectory, limits_);
    result_.refined = std::move(free);
    if (slowdown.factor <= 1) return true;
    result_.too_fast = slowdown;
    return false;
  }

  void slow_down(double margin) {
    const Trajectory& motion = result_.refined.trajectory;
    const double duration = motion.times().back() - motion.times().front();
    const SpeedProfileOptions options{
        margin, std::min(duration / kFastestSpans, 0.4 * input_.options.smoothing_time)};
    Trajectory law = speed_profile(motion, limits_, options);
    result_.task = run_along(result_.task, law);
    path_ = at_waypoints_of(result_.task, motion.waypoints());
    result_.law = result_.law ? run_along(*result_.law, law) : std::move(law);
  }

  const RefinementInput& input_;
  const Robot unlimited_;
  const Rates limits_;
  JointPath path_;
  SpeedRefined result_;
};

}  // namespace

SpeedRefined refine_at_weld_speed(const RefinementInput& input, const JointPath& seed) {
  return WeldSpeed(input, seed).run();
}

}  // namespace wristwise
