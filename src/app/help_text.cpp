#include "app/help_text.hpp"

#include <algorithm>

#include "app/command_help.hpp"
#include "app/display_width.hpp"
#include "app/text_table.hpp"
#include "app/wrapped.hpp"

namespace wristwise::app {

namespace {

constexpr int kWidth = 80;
constexpr const char* kExitStatus =
    "  0    solved and verified\n"
    "  1    no trajectory that meets the problem; the diagnosis says why\n"
    "  2    invalid input: one line on stderr, nothing written\n"
    "  3    internal error\n"
    "  130  interrupted; what there was until then is written\n";

std::string option_names(const CLI::Option& option) {
  if (option.get_positional()) return option.get_name();
  std::string text;
  for (const std::string& name : option.get_snames()) text += "-" + name + ", ";
  for (const std::string& name : option.get_lnames()) text += "--" + name;
  if (option.get_type_size() == 0) return text;
  const std::string type = option.get_type_name();  // "MODE:{two-stage,graph-only}"
  return text + " " + type.substr(0, type.find(':'));
}

std::string table_text(const std::vector<TableRow>& rows) {
  return wrapped(aligned(rows, 2, Flush::left), kWidth);
}

/// Options in their groups, in the order in which these were made; arguments first in theirs.
std::string options_text(const CLI::App& app, const Paint& paint) {
  std::vector<std::string> groups;
  for (const CLI::Option* option : app.get_options()) {
    if (std::find(groups.begin(), groups.end(), option->get_group()) == groups.end())
      groups.push_back(option->get_group());
  }
  std::string text;
  for (const std::string& group : groups) {
    std::vector<TableRow> rows;
    for (const CLI::Option* option : app.get_options())
      if (option->get_group() == group)
        rows.push_back({option_names(*option), option->get_description()});
    text += "\n" + paint.bold(group) + "\n" + table_text(rows);
  }
  return text;
}

std::string usage(const CLI::App& command) {
  std::string text = "wristwise " + command.get_name();
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_positional())
      text += option->get_required() ? " " + option->get_name() : " [" + option->get_name() + "]";
    else if (option->get_required())
      text += " " + option_names(*option);
  }
  return text + " [OPTIONS]";
}

std::string examples_text(const std::vector<Example>& examples, const Paint& paint) {
  std::string text = "\n" + paint.bold("Examples") + "\n";
  for (const Example& example : examples)
    text += "  # " + example.purpose + "\n  " + example.command + "\n";
  return text;
}

std::string exit_status_text(const Paint& paint) {
  return "\n" + paint.bold("Exit status") + "\n" + kExitStatus;
}

const CommandHelp& help_of(const std::string& name) {
  const auto& all = command_help();
  return *std::find_if(all.begin(), all.end(),
                       [&](const CommandHelp& help) { return help.name == name; });
}

}  // namespace

std::string program_help(const CLI::App& program, const Paint& paint) {
  std::string text = program.get_description() + "\n\n" + paint.bold("Usage") +
                     "\n  wristwise COMMAND [OPTIONS]\n\n" + paint.bold("Commands") + "\n";
  std::vector<TableRow> rows;
  for (const CommandHelp& help : command_help()) rows.push_back({help.name, help.purpose});
  text += table_text(rows) + options_text(program, paint);
  text += examples_text(
      {{"a problem file to start from", "wristwise new my_seam.yaml"},
       {"plan it, and look at out/my_seam/report.html in a browser", "wristwise plan my_seam.yaml"},
       {"options and examples of a command", "wristwise plan --help"}},
      paint);
  return text + exit_status_text(paint) +
         "\nDocumentation: docs/ of the source; installed, share/doc/wristwise.\n";
}

std::string command_help_text(const CLI::App& program, const CLI::App& command,
                              const Paint& paint) {
  const CommandHelp& help = help_of(command.get_name());
  std::string text = help.purpose + "\n" + wrapped(help.text, kWidth, 0) + "\n" +
                     paint.bold("Usage") + "\n  " + usage(command) + "\n" +
                     options_text(command, paint) + options_text(program, paint) +
                     examples_text(help.examples, paint) + exit_status_text(paint) + "\n" +
                     paint.bold("Read on") + "\n";
  for (const std::string& page : help.pages) text += "  docs/" + page + "\n";
  return text;
}

}  // namespace wristwise::app
