#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>

#include "app/commands.hpp"
#include "app/exit_code.hpp"
#include "app/interrupt.hpp"
#include "similar_names.hpp"
#include "wristwise/error.hpp"
#include "wristwise/version.hpp"

namespace wristwise::app {

namespace {

constexpr int kMostThreads = 1024;

void print_error(std::string message) {
  std::replace(message.begin(), message.end(), '\n', ' ');
  fmt::print(stderr, "wristwise: {}\n", message);
}

CLI::App& add_command(CLI::App& program, const std::string& name, const std::string& purpose) {
  CLI::App& command = *program.add_subcommand(name, purpose);
  command.footer("--quiet, --threads N and --no-cache go with every command.");
  return command;
}

/// The command line: what is asked for, and the function that does it.
class CommandLine {
 public:
  CommandLine() {
    program_.require_subcommand(1);
    program_.fallthrough();
    program_.set_version_flag("--version", std::string("wristwise ") + library_version());
    program_.add_flag("--quiet", settings_.quiet, "No progress and no log lines");
    program_.add_option("--threads", settings_.threads, "Threads; 0, the default: one per core")
        ->check(CLI::Range(0, kMostThreads));
    program_.add_flag("--no-cache", settings_.no_cache,
                      "Read meshes afresh, write no .wristwise_cache beside the problem");
    add_plan();
    add_smooth();
    add_check();
    add_compare();
    add_place();
    add_info();
  }

  int run(int argc, char** argv) {
    check_command_name(argc, argv);
    try {
      program_.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
      if (error.get_exit_code() == 0) return program_.exit(error);
      throw InvalidInput("command line", error.what());
    }
    return action_();
  }

 private:
  void check_command_name(int argc, char** argv) const {
    if (argc < 2 || argv[1][0] == '-') return;
    const std::string given = argv[1];
    std::vector<std::string> names;
    for (const CLI::App* command : program_.get_subcommands({}))
      names.push_back(command->get_name());
    if (std::find(names.begin(), names.end(), given) == names.end())
      throw InvalidInput("command line", "unknown command '" + given + "'",
                         "a command such as " + similar_names(given, names, 1));
  }

  void add_out(CLI::App& command, std::filesystem::path& out) {
    command.add_option("--out", out, "Folder for the results; default: out/<problem>");
  }

  void add_no_report(CLI::App& command, bool& no_report) {
    command.add_flag("--no-report", no_report, "Write no report.html");
  }

  void add_plot(CLI::App& command, bool& plot) {
    command.add_flag("--plot", plot,
                     "Pictures too (SVG): joint profiles with limits, use of the tolerance");
  }

  void add_problem(CLI::App& command, std::filesystem::path& problem) {
    command.add_option("PROBLEM", problem, "Problem file (YAML)")->required();
  }

  void add_export(CLI::App& command, std::vector<std::string>& formats) {
    command
        .add_option("--export", formats,
                    "Robot program too: krl, rapid, ls, trajectory_msgs or moveit; several with "
                    "commas, or the option again")
        ->allow_extra_args(false);
  }

  void add_plan() {
    CLI::App& command = add_command(program_, "plan", "Plan a seam");
    add_problem(command, plan_.problem);
    command.add_option("--mode", plan_.mode, "two-stage (default) or graph-only")
        ->check(CLI::IsMember({"two-stage", "graph-only"}));
    add_out(command, plan_.out);
    add_export(command, plan_.exports);
    add_no_report(command, plan_.no_report);
    add_plot(command, plan_.plot);
    command.callback([this] { action_ = [this] { return run_plan(plan_, settings_); }; });
  }

  void add_smooth() {
    CLI::App& command = add_command(program_, "smooth", "Repair an existing joint path");
    command.add_option("PROBLEM", smooth_.problem, "Problem file (YAML); or --urdf and --keep");
    command
        .add_option("--joints", smooth_.joints,
                    "Joint path (CSV, YAML of ROS) or program (.src, .mod, .ls) to smooth")
        ->required();
    command.add_option("--out", smooth_.out,
                       "Folder for the results; default: out/<problem> or out/<joint path>");
    command.add_option("--smoothing-time", smooth_.smoothing_time,
                       "Time to smooth over, s; default: the problem's, or by the path");
    command.add_option("--urdf", smooth_.urdf, "Without a problem: robot description (URDF)");
    command.add_option("--base", smooth_.base_link, "Base link; default: the root");
    command.add_option("--part", smooth_.part_link, "Link of the part; default: the base link");
    command.add_option("--tip", smooth_.tip_link, "Tip link; default: of the longest chain");
    command.add_option("--limits", smooth_.limits, "Joint limits (YAML); default: the URDF's");
    command.add_option("--keep", smooth_.keep,
                       "How far the TCP may be moved and turned, such as 0.5mm,0.5deg");
    command.add_flag("--no-self-collision", smooth_.no_self_collision,
                     "Don't keep the links clear of each other, don't read their meshes");
    add_export(command, smooth_.exports);
    add_no_report(command, smooth_.no_report);
    add_plot(command, smooth_.plot);
    command.callback([this] { action_ = [this] { return run_smooth(smooth_, settings_); }; });
  }

  void add_check() {
    CLI::App& command = add_command(program_, "check", "Check any trajectory independently");
    add_problem(command, check_.problem);
    command.add_option("TRAJECTORY", check_.trajectory, "Trajectory (CSV)")->required();
    command.add_flag("--json", check_.json, "Print the verification as JSON");
    command.callback([this] { action_ = [this] { return run_check(check_, settings_); }; });
  }

  void add_compare() {
    CLI::App& command = add_command(program_, "compare", "Graph-only beside two-stage");
    add_problem(command, compare_.problem);
    add_out(command, compare_.out);
    add_no_report(command, compare_.no_report);
    add_plot(command, compare_.plot);
    command.callback([this] { action_ = [this] { return run_compare(compare_, settings_); }; });
  }

  void add_place() {
    CLI::App& command =
        add_command(program_, "place", "Find where in a region the part or the robot should stand");
    add_problem(command, place_.problem);
    add_out(command, place_.out);
    command.callback([this] { action_ = [this] { return run_place(place_, settings_); }; });
  }

  void add_info() {
    CLI::App& command = add_command(program_, "info", "Look at a robot description");
    command.add_option("ROBOT", info_.urdf, "Robot description (URDF)")->required();
    command.add_option("--base", info_.base_link, "Base link; default: the root");
    command.add_option("--part", info_.part_link, "Link of the part; default: the base link");
    command.add_option("--tip", info_.tip_link, "Tip link; default: of the longest chain");
    command.add_option("--limits", info_.limits, "Joint limits (YAML)");
    command.add_option("--srdf", info_.srdf, "SRDF, for --group and disabled pairs");
    command.add_option("--group", info_.group, "Group of the SRDF: gives base and tip");
    command.add_option("--package", info_.packages,
                       "Folder for package://, before ROS_PACKAGE_PATH; may be repeated");
    command
        .add_option("--collision-from", info_.collision_from,
                    "visual: links without collision shapes take their visual ones")
        ->check(CLI::IsMember({"collision", "visual"}));
    command.callback([this] { action_ = [this] { return run_info(info_); }; });
  }

  CLI::App program_{"Plans smooth, collision-free joint trajectories for arc-welding robots",
                    "wristwise"};
  Settings settings_;
  PlanCommand plan_;
  SmoothCommand smooth_;
  CheckCommand check_;
  CompareCommand compare_;
  PlaceCommand place_;
  InfoCommand info_;
  std::function<int()> action_;
};

}  // namespace

int run(int argc, char** argv) {
  catch_interrupts();
  try {
    return CommandLine().run(argc, argv);
  } catch (const InvalidInput& error) {
    print_error(error.what());
    return kInvalidInput;
  } catch (const std::exception& error) {
    print_error(std::string("internal error: ") + error.what());
    return kInternalError;
  } catch (...) {
    print_error("internal error");
    return kInternalError;
  }
}

}  // namespace wristwise::app

int main(int argc, char** argv) { return wristwise::app::run(argc, argv); }
