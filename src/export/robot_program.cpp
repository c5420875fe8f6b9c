#include "wristwise/robot_program.hpp"

#include <algorithm>
#include <cmath>

#include "export/point_choice.hpp"
#include "export/weld_stretches.hpp"
#include "io/result_file.hpp"
#include "wristwise/error.hpp"

namespace wristwise {

namespace {

void require_positive(double value, const char* key) {
  if (!(value > 0) || !std::isfinite(value))
    throw InvalidInput(std::string("export.") + key, std::to_string(value), "a number above zero");
}

void require_percent(double percent) {
  if (!(percent >= 1 && percent <= 100))
    throw InvalidInput("export.approach_percent", std::to_string(percent), "1 to 100");
}

PointChoice point_choice(const Problem& problem) {
  const ExportOptions& options = problem.exports;
  require_positive(options.max_deviation, "max_deviation");
  require_positive(options.max_angle_deviation, "max_deviation");
  if (options.period) require_positive(*options.period, "period");
  return {options.max_deviation, options.max_angle_deviation, options.period,
          problem.controller_period};
}

std::vector<double> ends(const std::vector<WeldStretch>& stretches) {
  std::vector<double> times;
  for (const WeldStretch& stretch : stretches) {
    times.push_back(stretch.from);
    times.push_back(stretch.to);
  }
  return times;
}

bool is_inside(double t, const std::vector<WeldStretch>& stretches) {
  return std::any_of(stretches.begin(), stretches.end(), [&](const WeldStretch& stretch) {
    return stretch.from < t && t < stretch.to;
  });
}

JointPath thinned(const Trajectory& curve, const Problem& problem, const std::vector<double>& keep,
                  RobotProgram& program) {
  const ChosenPoints chosen = choose_points(*problem.robot, curve, keep, point_choice(problem));
  program.deviation = chosen.deviation;
  program.angle_deviation = chosen.angle_deviation;
  JointPath path{chosen.times, {}};
  for (const double t : path.times) path.positions.push_back(curve.evaluate(t));
  return path;
}

}  // namespace

RobotProgram robot_program(const PlanResult& result, const Problem& problem) {
  require_percent(problem.exports.approach_percent);
  RobotProgram program;
  program.name = problem.exports.name.empty() ? problem.name : problem.exports.name;
  std::vector<WeldStretch> stretches;
  if (problem.exports.weld) stretches = weld_stretches(task_as_run(result, problem));
  const JointPath path = result.trajectory.empty()
                             ? result.path
                             : thinned(result.trajectory, problem, ends(stretches), program);
  validate(path, problem.robot->joint_count(), "export");
  for (std::size_t i = 0; i < path.size(); ++i) {
    const bool welding = i > 0 && is_inside(0.5 * (path.times[i - 1] + path.times[i]), stretches);
    program.points.push_back({path.times[i] - path.times[0], path.positions[i], welding});
  }
  return program;
}

}  // namespace wristwise
