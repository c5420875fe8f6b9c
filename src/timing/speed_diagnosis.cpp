#include "timing/speed_diagnosis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "cancelled.hpp"
#include "timing/highest_speed.hpp"
#include "timing/retiming.hpp"

namespace wristwise {

namespace {

std::size_t nearest_waypoint(const Task& task, double t) {
  const auto nearer = [t](const Waypoint& a, const Waypoint& b) {
    return std::abs(a.time - t) < std::abs(b.time - t);
  };
  const auto nearest = std::min_element(task.waypoints.begin(), task.waypoints.end(), nearer);
  return static_cast<std::size_t>(nearest - task.waypoints.begin());
}

/// m/s, of the piece that is run at a time; 0 on a move.
double weld_speed(const Seam& seam, double t) {
  const SeamPiece& piece = seam.piece_at(t);
  if (piece.kind == SeamPiece::Kind::move) return 0;
  return piece.length() / (piece.end_time - piece.start_time);
}

/// The factor, not less, at which the weld speed is a number of three digits: what is tried is what
/// is said.
double with_round_speed(double speed, double factor) {
  if (!(speed > 0)) return factor;
  const double unit = std::pow(10, std::floor(std::log10(speed / factor)) - 2);
  const double round = unit * std::floor(speed / factor / unit * (1 + 1e-12));
  return speed / round;
}

std::string other_help(const Task& task) {
  const bool hold = task.speed_policy == SpeedPolicy::hold;
  return hold ? ", or set path.speed_policy: slow, or widen the tolerance"
              : ", or widen the tolerance; slowing only where it must did not do";
}

Diagnosis describe(const Robot& robot, const Task& task, const UniformSlowdown& too_fast) {
  constexpr std::array<const char*, 3> kNames = {"velocity", "acceleration", "jerk"};
  const std::size_t waypoint = nearest_waypoint(task, too_fast.time);
  return {waypoint, "infeasible_at_this_speed",
          fmt::format("{} needs {:.3g} times its {} limit at {:.4g} s (waypoint {}) on the "
                      "smoothest motion that meets everything else",
                      robot.joints()[static_cast<std::size_t>(too_fast.joint)].name, too_fast.ratio,
                      kNames[static_cast<std::size_t>(too_fast.derivative - 1)], too_fast.time,
                      waypoint),
          "weld slower" + other_help(task)};
}

std::string suggest_speed(const Task& task, const UniformSlowdown& too_fast,
                          std::optional<double> factor) {
  if (!factor) return "no uniform speed that was tried works; try others" + other_help(task);
  const double speed = weld_speed(task.seam, too_fast.time);
  const std::string absolute = speed > 0 ? fmt::format("{:.3g} m/s, ", speed / *factor) : "";
  return fmt::format(
      "the highest uniform speed that works, found by trying to 2%, is {}{:.3g}% of the weld "
      "speed{}",
      absolute, 100 / *factor, other_help(task));
}

bool is_solved(const Problem& problem, double factor, const PlanOptions& options,
               const SlowerTrial& trial) {
  Problem slower = problem;
  slower.task = stretched(problem.task, factor);
  slower.task.speed_policy = SpeedPolicy::hold;
  slower.refine.try_speeds = slower.graph.try_relaxations = false;
  PlanOptions quiet = options;
  quiet.monitor = {nullptr, nullptr, options.monitor.cancel};
  const PlanResult result = trial(slower, factor, quiet);
  throw_if_cancelled(options.monitor);
  return result.status == Status::solved;
}

}  // namespace

bool fails_by_rates_only(const Verification& verification) {
  constexpr double kAtLimit = 1 + 1e-9;
  const std::array<double, 3> ratios = {verification.velocity_ratio,
                                        verification.acceleration_ratio, verification.jerk_ratio};
  const auto over =
      std::count_if(ratios.begin(), ratios.end(), [](double ratio) { return ratio > kAtLimit; });
  return over > 0 && verification.failures.size() == static_cast<std::size_t>(over);
}

Diagnosis diagnose_speed(const Problem& problem, const Task& task, const UniformSlowdown& too_fast,
                         const PlanOptions& options, const SlowerTrial& trial) {
  Diagnosis diagnosis = describe(*problem.robot, task, too_fast);
  if (problem.refine.try_speeds) {
    const double speed = weld_speed(task.seam, too_fast.time);
    const auto works = [&](double factor) {
      return is_solved(problem, with_round_speed(speed, factor), options, trial);
    };
    std::optional<double> least = least_working_factor(works, too_fast.factor);
    if (least) least = with_round_speed(speed, *least);
    diagnosis.suggestion = suggest_speed(task, too_fast, least);
  }
  return diagnosis;
}

}  // namespace wristwise
