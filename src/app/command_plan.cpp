#include <unistd.h>

#include "app/commands.hpp"
#include "app/exports.hpp"
#include "app/next_steps.hpp"
#include "app/output.hpp"
#include "app/output_folder.hpp"
#include "app/pictures.hpp"
#include "app/planning_run.hpp"
#include "app/required_file.hpp"
#include "app/summary.hpp"
#include "io/result_file.hpp"
#include "report/report.hpp"

namespace wristwise::app {

int run_plan(const PlanCommand& command, const Settings& settings) {
  require_file(command.problem, "a problem file", ".yaml");
  const std::filesystem::path folder = output_folder(command.out, command.problem);
  const std::vector<ProgramFormat> formats = export_formats(command.exports);
  const bool graph_only = command.mode == mode_name(Mode::graph_only);
  const Loader load = [&] {
    Problem problem = load_problem(command.problem, load_options(settings));
    check_exports(formats, problem);
    return problem;
  };
  const PlanningRun run = graph_only
                              ? run_planner(load, Mode::graph_only, plan_graph_only, settings)
                              : run_planner(load, Mode::two_stage, plan, settings);
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
