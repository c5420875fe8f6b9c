#include <unistd.h>

#include <optional>

#include "app/commands.hpp"
#include "app/exports.hpp"
#include "app/next_steps.hpp"
#include "app/output.hpp"
#include "app/output_folder.hpp"
#include "app/pictures.hpp"
#include "app/planning_run.hpp"
#include "app/required_file.hpp"
#include "app/summary.hpp"
#include "io/quantity.hpp"
#include "io/result_file.hpp"
#include "kinematics/robot_files.hpp"
#include "report/report.hpp"
#include "wristwise/error.hpp"
#include "wristwise/program_file.hpp"
#include "wristwise/smoothing.hpp"
#include "wristwise/urdf.hpp"

namespace wristwise::app {

namespace {

void require_problem_or_robot(const SmoothCommand& command) {
  if (command.problem.empty() && command.urdf.empty())
    throw InvalidInput("command line", "nothing says which robot it is",
                       "a PROBLEM, or --urdf and --keep");
  if (command.problem.empty()) {
    if (command.keep.empty())
      throw InvalidInput("command line", "--keep is missing",
                         "how far the TCP may be moved, such as --keep 0.5mm,0.5deg");
    return;
  }
  const bool has_robot = !command.urdf.empty() || !command.base_link.empty() ||
                         !command.part_link.empty() || !command.tip_link.empty() ||
                         !command.limits.empty();
  if (has_robot || !command.keep.empty() || command.no_self_collision)
    throw InvalidInput("command line",
                       "--urdf, --base, --part, --tip, --limits, --keep and --no-self-collision "
                       "do not go with a PROBLEM",
                       "either");
}

/// "0.5mm,0.5deg"
void read_keep(const std::string& text, SmoothingOptions& options) {
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos || text.find(',', comma + 1) != std::string::npos)
    throw InvalidInput("--keep", "'" + text + "'", "a length and an angle, such as 0.5mm,0.5deg");
  options.position_tolerance = parse_quantity(text.substr(0, comma), Quantity::length, "--keep");
  options.angle_tolerance = parse_quantity(text.substr(comma + 1), Quantity::angle, "--keep");
}

std::optional<double> read_smoothing_time(const std::string& text) {
  if (text.empty()) return std::nullopt;
  const double time = parse_quantity(text, Quantity::time, "--smoothing-time");
  if (time > 0) return time;
  throw InvalidInput("--smoothing-time", "'" + text + "'", "a positive time");
}

SmoothingOptions smoothing_options(const SmoothCommand& command) {
  SmoothingOptions options;
  read_keep(command.keep, options);
  options.smoothing_time = read_smoothing_time(command.smoothing_time);
  options.self_collision = !command.no_self_collision;
  return options;
}

RobotSource robot_source(const SmoothCommand& command) {
  RobotSource source;
  source.urdf = command.urdf;
  source.base_link = command.base_link;
  source.part_link = command.part_link;
  source.tip_link = command.tip_link;
  source.limits = command.limits;
  source.read_collision_shapes = !command.no_self_collision;
  return source;
}

SmoothingProblem load_with_problem(const SmoothCommand& command, const Settings& settings) {
  SmoothingProblem loaded;
  loaded.problem = load_problem(command.problem, load_options(settings));
  const Problem& problem = loaded.problem;
  loaded.path = read_joint_path(command.joints, *problem.robot, problem.exports,
                                problem.task.seam.start_time());
  if (const auto time = read_smoothing_time(command.smoothing_time))
    loaded.problem.refine.smoothing_time = *time;
  return loaded;
}

SmoothingProblem load_without_problem(const SmoothCommand& command) {
  const SmoothingOptions options = smoothing_options(command);
  const auto robot = std::make_shared<const Robot>(load_robot(robot_source(command)));
  SmoothingProblem loaded =
      smoothing_problem(robot, read_joint_path(command.joints, *robot, {}), options);
  loaded.problem.name = command.joints.stem().string();
  loaded.problem.exports.weld = false;  // nothing says where it welds
  loaded.problem.files = robot_files(robot_source(command));
  return loaded;
}

}  // namespace

int run_smooth(const SmoothCommand& command, const Settings& settings) {
  require_problem_or_robot(command);
  const bool with_problem = !command.problem.empty();
  if (with_problem) require_file(command.problem, "a problem file", ".yaml");
  require_file(command.joints, "a joint path", ".csv");
  const std::filesystem::path folder =
      output_folder(command.out, with_problem ? command.problem : command.joints);
  const std::vector<ProgramFormat> formats = export_formats(command.exports);
  JointPath path;
  std::vector<std::string> warnings;
  const Loader load = [&] {
    SmoothingProblem loaded =
        with_problem ? load_with_problem(command, settings) : load_without_problem(command);
    path = std::move(loaded.path);
    warnings = std::move(loaded.warnings);
    check_exports(formats, loaded.problem);
    loaded.problem.files.push_back(command.joints);
    return std::move(loaded.problem);
  };
  const Planner repair = [&](const Problem& problem, const PlanOptions& options) {
    PlanResult result = smooth(problem, path, options);
    result.warnings.insert(result.warnings.begin(), warnings.begin(), warnings.end());
    return result;
  };
  const PlanningRun run = run_planner(load, Mode::smooth, repair, settings);
  write_result(folder, run.result, run.problem);
  if (!command.no_report) write_report(folder, {run.problem, run.result, nullptr, run.inputs});
  const Paint paint(settings.colour, STDOUT_FILENO);
  print(summary(run.result, run.problem, paint) +
        write_exports(formats, folder, run.result, run.problem) +
        write_pictures(command.plot, folder, run.problem, run.result) +
        next_steps(run.result, {command.problem, folder, !command.no_report}, paint));
  return run.exit_code;
}

}  // namespace wristwise::app
