#include <fmt/format.h>
#include <unistd.h>

#include "app/commands.hpp"
#include "app/console.hpp"
#include "app/exit_code.hpp"
#include "app/interrupt.hpp"
#include "app/output.hpp"
#include "app/required_file.hpp"
#include "app/verification_table.hpp"
#include "io/result_file.hpp"
#include "wristwise/trajectory_file.hpp"

namespace wristwise::app {

int run_check(const CheckCommand& command, const Settings& settings) {
  require_file(command.problem, "a problem file", ".yaml");
  require_file(command.trajectory, "a trajectory", ".csv");
  const Problem problem = load_problem(command.problem, load_options(settings));
  const TrajectoryFile file = read_trajectory(command.trajectory, problem.robot->joint_names());
  Verification verification;
  {
    Console console(settings);
    const PlanOptions options = console.plan_options(problem);
    verification = check(problem, file, options);
  }
  if (interrupted()) return kInterrupted;
  if (command.json)
    fmt::print("{}", verification_json(verification, problem));
  else
    print(verification_table(verification, problem, Paint(settings.colour, STDOUT_FILENO)));
  return verification.passed ? kSolved : kNotSolved;
}

}  // namespace wristwise::app
