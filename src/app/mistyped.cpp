#include "app/mistyped.hpp"

#include <algorithm>
#include <cctype>

#include "similar_names.hpp"
#include "wristwise/error.hpp"

namespace wristwise::app {

namespace {

std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
  }
  return names;
}

/// "--out" of "--out=folder"; empty for what is no option, such as a negative number.
std::string option_name(const std::string& argument) {
  const std::size_t first = argument.find_first_not_of('-');
  const bool is_option = first == 1 || first == 2;
  if (!is_option || std::isalpha(static_cast<unsigned char>(argument[first])) == 0) return {};
  return argument.substr(0, argument.find('='));
}

bool is_among(const std::string& name, const std::vector<std::string>& names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::vector<std::string> command_names(const CLI::App& program) {
  std::vector<std::string> names;
  for (const CLI::App* command : program.get_subcommands({})) names.push_back(command->get_name());
  return names;
}

}  // namespace

void check_names(const CLI::App& program, const std::vector<std::string>& arguments) {
  const std::vector<std::string> commands = command_names(program);
  const auto command = std::find_if(arguments.begin(), arguments.end(),
                                    [&](const auto& name) { return is_among(name, commands); });
  if (command == arguments.end() && !arguments.empty() && arguments.front()[0] != '-')
    throw InvalidInput("command line", "unknown command '" + arguments.front() + "'",
                       "a command such as " + similar_names(arguments.front(), commands, 1) +
                           ", see wristwise --help");
  std::vector<std::string> known = option_names(program);
  std::string whose = "wristwise";
  if (command != arguments.end()) {
    const auto own = option_names(*program.get_subcommand(*command));
    known.insert(known.end(), own.begin(), own.end());
    whose += " " + *command;
  }
  for (const std::string& argument : arguments) {
    const std::string name = option_name(argument);
    if (name.empty() || is_among(name, known)) continue;
    throw InvalidInput(
        "command line", "unknown option '" + name + "'",
        "an option such as " + similar_names(name, known, 1) + ", see " + whose + " --help");
  }
}

}  // namespace wristwise::app
