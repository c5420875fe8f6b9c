#pragma once

#include <filesystem>
#include <string>

#include "app/paint.hpp"
#include "wristwise/plan.hpp"

namespace wristwise::app {

/// What a planning command was given and where its results are.
struct RunFiles {
  std::filesystem::path problem;  ///< empty: none was given
  std::filesystem::path folder;
  bool report = true;  ///< report.html was written
};

/// Where the results are, and which command or key of the problem file to try next.
std::string next_steps(const PlanResult& result, const RunFiles& files, const Paint& paint);

}  // namespace wristwise::app
