#include <unistd.h>

#include "app/commands.hpp"
#include "app/comparison_table.hpp"
#include "app/exit_code.hpp"
#include "app/next_steps.hpp"
#include "app/output.hpp"
#include "app/output_folder.hpp"
#include "app/pictures.hpp"
#include "app/planning_run.hpp"
#include "app/required_file.hpp"
#include "io/result_file.hpp"
#include "report/report.hpp"

namespace wristwise::app {

int run_compare(const CompareCommand& command, const Settings& settings) {
  require_file(command.problem, "a problem file", ".yaml");
  const std::filesystem::path folder = output_folder(command.out, command.problem);
  const Loader load = [&] { return load_problem(command.problem, load_options(settings)); };
  const PlanningRun graph_only = run_planner(load, Mode::graph_only, plan_graph_only, settings);
  write_result(folder / "graph-only", graph_only.result, graph_only.problem);
  if (graph_only.exit_code == kInterrupted || graph_only.exit_code == kInternalError)
    return graph_only.exit_code;
  const PlanningRun two_stage = run_planner(load, Mode::two_stage, plan, settings);
  write_result(folder / "two-stage", two_stage.result, two_stage.problem);
  if (!command.no_report)
    write_report(folder,
                 {two_stage.problem, two_stage.result, &graph_only.result, two_stage.inputs});
  const Paint paint(settings.colour, STDOUT_FILENO);
  print(comparison_table(graph_only.result, two_stage.result, graph_only.problem, paint) +
        write_pictures(command.plot, folder, two_stage.problem, two_stage.result,
                       &graph_only.result) +
        next_steps(two_stage.result, {command.problem, folder, !command.no_report}, paint));
  return two_stage.exit_code;
}

}  // namespace wristwise::app
