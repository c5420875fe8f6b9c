#include <fmt/format.h>

#include "app/commands.hpp"
#include "app/joint_names.hpp"
#include "app/output_folder.hpp"
#include "app/planning_run.hpp"
#include "app/summary.hpp"
#include "io/result_file.hpp"
#include "wristwise/trajectory_file.hpp"

namespace wristwise::app {

int run_smooth(const SmoothCommand& command, const Settings& settings) {
  const std::filesystem::path folder = output_folder(command.out, command.problem);
  const Planner repair = [&](const Problem& problem, const PlanOptions& options) {
    const TrajectoryFile file = read_trajectory(command.joints, joint_names(*problem.robot));
    return smooth(problem, file.path, options);
  };
  const PlanningRun run = run_planner(command.problem, Mode::smooth, repair, settings);
  write_result(folder, run.result, run.problem);
  fmt::print("{}", summary(run.result, run.problem, folder));
  return run.exit_code;
}

}  // namespace wristwise::app
