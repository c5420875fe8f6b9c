#include <fmt/format.h>

#include "app/commands.hpp"
#include "app/console.hpp"
#include "app/exit_code.hpp"
#include "app/interrupt.hpp"
#include "app/verification_table.hpp"
#include "io/result_file.hpp"
#include "wristwise/trajectory_file.hpp"

namespace wristwise::app {

int run_check(const CheckCommand& command, const Settings& settings) {
  const Problem problem = load_problem(command.problem, load_options(settings));
  const TrajectoryFile file = read_trajectory(command.trajectory, problem.robot->joint_names());
  Verification verification;
  {
    Console console(settings);
    const PlanOptions options = console.plan_options(problem);
    verification = check(problem, file, options);
  }
  if (interrupted()) return kInterrupted;
  fmt::print("{}", command.json ? verification_json(verification, problem)
                                : verification_table(verification, problem));
  return verification.passed ? kSolved : kNotSolved;
}

}  // namespace wristwise::app
