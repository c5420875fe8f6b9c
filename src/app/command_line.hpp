#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

#include "app/commands.hpp"

namespace wristwise::app {

/// The command line: what is asked for, and the function that does it.
class CommandLine {
 public:
  CommandLine();

  /// @return the exit status. @throws InvalidInput
  int run(std::vector<std::string> arguments);

  /// As far as the arguments have been read.
  ColourChoice colour() const;

 private:
  template <class Command>
  void add(const std::string& name, Command& command,
           int (*run_command)(const Command&, const Settings&));
  void parse(const std::vector<std::string>& arguments);
  int print_help() const;

  CLI::App program_;
  Settings settings_;
  CLI::Option* colour_ = nullptr;
  PlanCommand plan_;
  SmoothCommand smooth_;
  CheckCommand check_;
  CompareCommand compare_;
  PlaceCommand place_;
  InfoCommand info_;
  NewCommand new_;
  std::function<int()> action_;
};

}  // namespace wristwise::app
