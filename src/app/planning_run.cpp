#include "app/planning_run.hpp"

#include <chrono>
#include <exception>

#include "app/console.hpp"
#include "app/exit_code.hpp"
#include "wristwise/error.hpp"

namespace wristwise::app {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

PlanResult failed_result(Mode mode, const std::string& what) {
  PlanResult result;
  result.mode = mode;
  result.status = Status::failed;
  result.diagnosis.push_back(
      {std::nullopt, "internal_error", what, "please report this with the problem file"});
  return result;
}

}  // namespace

PlanningRun run_planner(const Loader& load, Mode mode, const Planner& planner,
                        const Settings& settings) {
  Console console(settings);
  PlanningRun run{};
  const Clock::time_point start = Clock::now();
  try {
    run.problem = load();
    run.inputs = input_files(run.problem.files);
    const double load_time = seconds_since(start);
    run.result = planner(run.problem, console.plan_options(run.problem));
    run.result.timing.load = load_time;
    run.exit_code = exit_code_of(run.result.status);
  } catch (const InvalidInput&) {
    throw;
  } catch (const std::exception& error) {
    run.result = failed_result(mode, error.what());
    run.exit_code = kInternalError;
  } catch (...) {
    run.result = failed_result(mode, "an unknown exception");
    run.exit_code = kInternalError;
  }
  run.result.timing.total = seconds_since(start);
  return run;
}

}  // namespace wristwise::app
