#include "app/command_line.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <map>

#include "app/arguments.hpp"
#include "app/command_help.hpp"
#include "app/help_text.hpp"
#include "app/mistyped.hpp"
#include "wristwise/error.hpp"
#include "wristwise/version.hpp"

namespace wristwise::app {

namespace {

constexpr int kMostThreads = 1024;
constexpr const char* kGroup = "Every command";

const std::map<std::string, ColourChoice> kColours = {{"auto", ColourChoice::automatic},
                                                      {"always", ColourChoice::always},
                                                      {"never", ColourChoice::never}};

std::string purpose_of(const std::string& name) {
  for (const CommandHelp& help : command_help())
    if (help.name == name) return help.purpose;
  return {};
}

}  // namespace

CommandLine::CommandLine()
    : program_("Plans smooth, collision-free joint trajectories for arc-welding robots",
               "wristwise") {
  program_.require_subcommand(1);
  program_.fallthrough();
  program_.set_help_flag("-h,--help", "Print this help")->group(kGroup);
  program_
      .set_version_flag("--version", std::string("wristwise ") + library_version(),
                        "Print the version")
      ->group(kGroup);
  program_.add_flag("--quiet", settings_.quiet, "No progress and no log lines")->group(kGroup);
  program_.add_option("--threads", settings_.threads, "Threads; 0, the default: one per core")
      ->type_name("N")
      ->check(CLI::Range(0, kMostThreads))
      ->group(kGroup);
  program_
      .add_flag("--no-cache", settings_.no_cache,
                "Read meshes afresh, write no .wristwise_cache beside the problem")
      ->group(kGroup);
  colour_ = program_
                .add_option("--color",
                            "auto (default): on a terminal, unless NO_COLOR is set; "
                            "always; never")
                ->type_name("WHEN")
                ->check(CLI::IsMember({"auto", "always", "never"}))
                ->group(kGroup);
  add("new", new_, run_new);
  add("plan", plan_, run_plan);
  add("smooth", smooth_, run_smooth);
  add("check", check_, run_check);
  add("compare", compare_, run_compare);
  add("place", place_, run_place);
  add("info", info_, run_info);
}

template <class Command>
void CommandLine::add(const std::string& name, Command& command,
                      int (*run_command)(const Command&, const Settings&)) {
  CLI::App& app = *program_.add_subcommand(name, purpose_of(name));
  app.set_help_flag("");  // the program's is for all
  add_arguments(app, command);
  app.callback([this, &command, run_command] {
    action_ = [this, &command, run_command] { return run_command(command, settings_); };
  });
}

int CommandLine::run(std::vector<std::string> arguments) {
  if (!arguments.empty() && arguments.front() == "help") {
    arguments.erase(arguments.begin());
    arguments.push_back("--help");
  }
  check_names(program_, arguments);
  try {
    parse(arguments);
  } catch (const CLI::CallForHelp&) {
    return print_help();
  } catch (const CLI::CallForVersion& version) {
    fmt::print("{}\n", version.what());
    return 0;
  }
  settings_.colour = colour();
  return action_();
}

void CommandLine::parse(const std::vector<std::string>& arguments) {
  try {
    program_.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
  } catch (const CLI::Success&) {  // help or version is asked for
    throw;
  } catch (const CLI::ParseError& error) {
    const auto commands = program_.get_subcommands();
    if (commands.empty() &&
        error.get_exit_code() == static_cast<int>(CLI::ExitCodes::RequiredError))
      throw InvalidInput("command line", "no command", "one that wristwise --help shows");
    const std::string command = commands.empty() ? "" : " " + commands.front()->get_name();
    throw InvalidInput("command line",
                       std::string(error.what()) + "; see wristwise" + command + " --help");
  }
}

ColourChoice CommandLine::colour() const {
  const auto& given = colour_->results();
  const auto found = given.empty() ? kColours.end() : kColours.find(given.back());
  return found == kColours.end() ? ColourChoice::automatic : found->second;
}

int CommandLine::print_help() const {
  const Paint paint(colour(), STDOUT_FILENO);
  const auto commands = program_.get_subcommands();
  fmt::print("{}", commands.empty() ? program_help(program_, paint)
                                    : command_help_text(program_, *commands.front(), paint));
  return 0;
}

}  // namespace wristwise::app
