#include <fmt/format.h>

#include "app/commands.hpp"
#include "app/output_folder.hpp"
#include "app/planning_run.hpp"
#include "app/summary.hpp"
#include "io/result_file.hpp"
#include "report/report.hpp"

namespace wristwise::app {

int run_plan(const PlanCommand& command, const Settings& settings) {
  const std::filesystem::path folder = output_folder(command.out, command.problem);
  const bool graph_only = command.mode == mode_name(Mode::graph_only);
  const Loader load = [&] { return load_problem(command.problem, load_options(settings)); };
  const PlanningRun run = graph_only
                              ? run_planner(load, Mode::graph_only, plan_graph_only, settings)
                              : run_planner(load, Mode::two_stage, plan, settings);
  write_result(folder, run.result, run.problem);
  if (!command.no_report) write_report(folder, {run.problem, run.result, nullptr, run.inputs});
  fmt::print("{}", summary(run.result, run.problem, folder));
  return run.exit_code;
}

}  // namespace wristwise::app
