#pragma once

#include <string>
#include <vector>

namespace wristwise::app {

struct Example {
  std::string purpose;
  std::string command;  ///< runs as it stands in the folder with problems/ and robots/
};

/// What the help of a command says beside its options.
struct CommandHelp {
  std::string name, purpose, text;
  std::vector<Example> examples;
  std::vector<std::string> pages;  ///< of docs/
};

/// Every command, in the order of the help.
const std::vector<CommandHelp>& command_help();

}  // namespace wristwise::app
