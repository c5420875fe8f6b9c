#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "app/paint.hpp"

namespace wristwise::app {

/// What `wristwise --help` prints: the commands, the options of all, examples. At most 80 columns.
std::string program_help(const CLI::App& program, const Paint& paint);

/// What `wristwise COMMAND --help` prints. At most 80 columns, but for examples, which can be
/// copied whole.
std::string command_help_text(const CLI::App& program, const CLI::App& command, const Paint& paint);

}  // namespace wristwise::app
