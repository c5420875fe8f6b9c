#include "app/commands.hpp"
#include "app/exports.hpp"
#include "app/output_folder.hpp"
#include "app/planning_run.hpp"
#include "app/required_file.hpp"
#include "app/run_output.hpp"
#include "io/result_file.hpp"

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
  leave_output(run, {folder, command.problem, formats, !command.no_report, command.plot}, settings);
  return run.exit_code;
}

}  // namespace wristwise::app
