#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "wristwise/robot_program.hpp"

namespace wristwise::app {

/// What --export asks for: names, each perhaps several with commas between them. @throws
/// InvalidInput for an unknown one.
std::vector<ProgramFormat> export_formats(const std::vector<std::string>& names);

/// @throws InvalidInput where one of them cannot take this robot
void check_exports(const std::vector<ProgramFormat>& formats, const Problem& problem);

/// Writes them. @return a line for each, for people
std::string write_exports(const std::vector<ProgramFormat>& formats,
                          const std::filesystem::path& folder, const PlanResult& result,
                          const Problem& problem);

}  // namespace wristwise::app
