#pragma once

#include <filesystem>
#include <functional>

#include "app/settings.hpp"
#include "io/input_file.hpp"
#include "wristwise/plan.hpp"

namespace wristwise::app {

using Loader = std::function<Problem()>;
using Planner = std::function<PlanResult(const Problem&, const PlanOptions&)>;

struct PlanningRun {
  Problem problem;  ///< empty where reading it failed
  std::vector<InputFile> inputs;
  PlanResult result;
  int exit_code = 0;
};

/// Loads the problem and runs the planner on it. An internal error becomes a failed result that
/// says so. @throws InvalidInput
PlanningRun run_planner(const Loader& load, Mode mode, const Planner& planner,
                        const Settings& settings);

}  // namespace wristwise::app
