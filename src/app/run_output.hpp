#pragma once

#include <filesystem>
#include <vector>

#include "app/planning_run.hpp"
#include "app/settings.hpp"
#include "wristwise/robot_program.hpp"

namespace wristwise::app {

/// What a run of one planner is to leave behind, besides result.json and the CSV files.
struct RunOutput {
  std::filesystem::path folder;
  std::filesystem::path problem;  ///< the file; empty: none
  std::vector<ProgramFormat> formats;
  bool report = true;
  bool pictures = false;
};

/// Writes the files and prints the summary.
void leave_output(const PlanningRun& run, const RunOutput& output, const Settings& settings);

}  // namespace wristwise::app
