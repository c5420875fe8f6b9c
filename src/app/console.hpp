#pragma once

#include "app/progress_bar.hpp"
#include "app/settings.hpp"
#include "wristwise/plan.hpp"

namespace wristwise::app {

/// Shows progress and log lines on stderr, and passes interrupts on.
class Console {
 public:
  explicit Console(const Settings& settings);

  /// Options whose monitor writes here; valid as long as the console.
  PlanOptions plan_options(const Problem& problem);

 private:
  Settings settings_;
  Paint paint_;
  ProgressBar bar_;
};

}  // namespace wristwise::app
