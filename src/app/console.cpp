#include "app/console.hpp"

#include <unistd.h>

#include "app/interrupt.hpp"

namespace wristwise::app {

Console::Console(const Settings& settings)
    : settings_(settings), paint_(settings.colour, STDERR_FILENO), bar_(!settings.quiet) {}

PlanOptions Console::plan_options(const Problem& problem) {
  PlanOptions options;
  options.threads = settings_.threads;
  options.verification.clearance_epsilon = problem.refine.clearance_epsilon;
  options.monitor.cancel = &interrupted();
  if (settings_.quiet) return options;
  options.monitor.progress = [this](const std::string& stage, double fraction) {
    bar_.show(stage, fraction);
  };
  options.monitor.log = [this](LogLevel level, const std::string& line) {
    bar_.print_line(level == LogLevel::warning ? paint_.warning("warning:") + " " + line : line);
  };
  return options;
}

}  // namespace wristwise::app
