#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace wristwise::app {

/// Looks for a command and options that do not exist.
/// @throws InvalidInput that names the nearest that does
void check_names(const CLI::App& program, const std::vector<std::string>& arguments);

}  // namespace wristwise::app
