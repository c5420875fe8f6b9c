#include "app/run_output.hpp"

#include <unistd.h>

#include "app/exports.hpp"
#include "app/next_steps.hpp"
#include "app/output.hpp"
#include "app/pictures.hpp"
#include "app/summary.hpp"
#include "io/result_file.hpp"
#include "report/report.hpp"

namespace wristwise::app {

void leave_output(const PlanningRun& run, const RunOutput& output, const Settings& settings) {
  write_result(output.folder, run.result, run.problem);
  if (output.report) write_report(output.folder, {run.problem, run.result, nullptr, run.inputs});
  const Paint paint(settings.colour, STDOUT_FILENO);
  print(summary(run.result, run.problem, paint) +
        write_exports(output.formats, output.folder, run.result, run.problem) +
        write_pictures(output.pictures, output.folder, run.problem, run.result) +
        next_steps(run.result, {output.problem, output.folder, output.report}, paint));
}

}  // namespace wristwise::app
