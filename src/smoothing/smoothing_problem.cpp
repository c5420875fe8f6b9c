#include <fmt/format.h>

#include <cmath>

#include "smoothing/drawn_path.hpp"
#include "smoothing/rest.hpp"
#include "smoothing/straight_time.hpp"
#include "smoothing/tolerance_ball.hpp"
#include "smoothing/touching_pairs.hpp"
#include "smoothing/whole_turns.hpp"
#include "wristwise/error.hpp"
#include "wristwise/smoothing.hpp"

namespace wristwise {

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kShortestStep = 1e-5;  ///< s; below it round-off is what the jerk shows
/// Of the tolerance, what the box at waypoints leaves to what holds between them.
constexpr double kBetweenShare = 0.1;
constexpr double kRestShare = 0.25;  ///< of the tolerance, within which the path stands still
constexpr int kMaxRounds = 100;      ///< noise adds points to the constraints again and again
constexpr double kKnotShare = 0.4;   ///< of the time over which the motion is nearly straight

constexpr const char* kRowsTooFarApart =
    "from point to point the given path bends, or its noise is, by more than the tolerance: a "
    "smooth curve may not be able to follow; denser points or a larger tolerance would help";

void check(const SmoothingOptions& options) {
  const auto positive = [](double value) { return value > 0 && std::isfinite(value); };
  if (!positive(options.position_tolerance))
    throw InvalidInput("position tolerance", fmt::format("{} m", options.position_tolerance),
                       "a positive length");
  if (!(options.angle_tolerance > 0 && options.angle_tolerance < kPi))
    throw InvalidInput("angle tolerance", fmt::format("{} rad", options.angle_tolerance),
                       "an angle between 0 and 180 deg");
  if (options.smoothing_time && !positive(*options.smoothing_time))
    throw InvalidInput("smoothing time", fmt::format("{} s", *options.smoothing_time),
                       "a positive time");
}

void check_steps(const JointPath& path) {
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const double step = path.times[i + 1] - path.times[i];
    if (step < kShortestStep)
      throw InvalidInput(fmt::format("joint path, point {}", i + 1),
                         fmt::format("its time, {:.9g} s, is {:.3g} s after the one before",
                                     path.times[i + 1], step),
                         "points at least 10 us apart");
  }
}

/// At waypoints the smaller box; between them, widened, the larger one.
Task keep(DrawnPath drawn, const SmoothingOptions& options, double rest_duration) {
  const double share = 1 - kChordShare;
  const ToleranceBox between =
      box_in_ball(share * options.position_tolerance, share * options.angle_tolerance);
  Task task;
  task.between_position = kBetweenShare * between.upper[0];
  task.between_angle = kBetweenShare * between.upper[3];
  const ToleranceBox at_waypoints = between.widened(-task.between_position, -task.between_angle);
  const double rest_position = kRestShare * options.position_tolerance;
  const double rest_angle = kRestShare * options.angle_tolerance;
  const auto& times = drawn.path.times;
  task.rest_at_start = rests_at_start(times, drawn.poses, rest_duration, rest_position, rest_angle);
  task.rest_at_end = rests_at_end(times, drawn.poses, rest_duration, rest_position, rest_angle);
  task.seam = std::move(drawn.seam);
  task.waypoints.resize(drawn.path.size());
  for (std::size_t i = 0; i < drawn.path.size(); ++i) {
    task.waypoints[i].time = drawn.path.times[i];
    task.waypoints[i].frame = drawn.poses[i];
    task.waypoints[i].tolerance = at_waypoints;
  }
  return task;
}

}  // namespace

SmoothingProblem smoothing_problem(const std::shared_ptr<const Robot>& robot, const JointPath& path,
                                   const SmoothingOptions& options) {
  check(options);
  validate(path, robot->joint_count(), "joint path");
  check_steps(path);
  Unwrapped unwrapped = without_whole_turns(*robot, path);
  DrawnPath drawn =
      draw_path(*robot, unwrapped.path, options.position_tolerance, options.angle_tolerance);

  SmoothingProblem result;
  result.path = drawn.path;
  result.warnings = std::move(unwrapped.warnings);
  Problem& problem = result.problem;
  problem.name = robot->name();
  problem.robot = robot;
  const StraightTime straight = straight_time(drawn.path.times, drawn.poses,
                                              options.position_tolerance, options.angle_tolerance);
  problem.refine.smoothing_time = options.smoothing_time.value_or(straight.time);
  problem.refine.max_rounds = kMaxRounds;
  problem.refine.knot_spacing = kKnotShare * straight.time;
  if (!straight.straight) result.warnings.push_back(kRowsTooFarApart);
  if (options.self_collision) {
    problem.scene.disabled = touching_pairs(robot, drawn.path, result.warnings);
  } else {
    problem.scene.scope = CollisionScope::off;
  }
  problem.task = keep(std::move(drawn), options, problem.refine.knot_spacing);
  return result;
}

PlanResult smooth(const std::shared_ptr<const Robot>& robot, const JointPath& path,
                  const SmoothingOptions& smoothing, const PlanOptions& options) {
  const SmoothingProblem given = smoothing_problem(robot, path, smoothing);
  PlanResult result = smooth(given.problem, given.path, options);
  result.warnings.insert(result.warnings.begin(), given.warnings.begin(), given.warnings.end());
  return result;
}

}  // namespace wristwise
