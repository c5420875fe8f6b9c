#pragma once

#include <CLI/CLI.hpp>

#include "app/commands.hpp"

// The options and arguments of each command, in groups as its help shows them.
namespace wristwise::app {

void add_arguments(CLI::App& app, PlanCommand& command);
void add_arguments(CLI::App& app, SmoothCommand& command);
void add_arguments(CLI::App& app, CheckCommand& command);
void add_arguments(CLI::App& app, CompareCommand& command);
void add_arguments(CLI::App& app, PlaceCommand& command);
void add_arguments(CLI::App& app, InfoCommand& command);
void add_arguments(CLI::App& app, NewCommand& command);

}  // namespace wristwise::app
