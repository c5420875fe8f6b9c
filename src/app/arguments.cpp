#include "app/arguments.hpp"

namespace wristwise::app {

namespace {

constexpr const char* kWhat = "What to do";
constexpr const char* kResults = "Results";
constexpr const char* kRobot = "Robot";
constexpr const char* kSeam = "Seam";

template <class Value>
CLI::Option& add(CLI::App& app, const char* group, const std::string& name, Value& value,
                 const char* type, const std::string& description) {
  return *app.add_option(name, value, description)->type_name(type)->group(group);
}

void add_flag(CLI::App& app, const char* group, const std::string& name, bool& value,
              const std::string& description) {
  app.add_flag(name, value, description)->group(group);
}

void add_problem(CLI::App& app, std::filesystem::path& problem) {
  add(app, kWhat, "PROBLEM", problem, "FILE", "Problem file (YAML)").required();
}

void add_out(CLI::App& app, std::filesystem::path& out, const std::string& otherwise) {
  add(app, kResults, "--out", out, "DIR", "Folder for the results; default: " + otherwise);
}

void add_no_report(CLI::App& app, bool& no_report) {
  add_flag(app, kResults, "--no-report", no_report, "Write no report.html");
}

void add_plot(CLI::App& app, bool& plot) {
  add_flag(app, kResults, "--plot", plot,
           "Pictures too (SVG): joint profiles with limits, use of the tolerance");
}

void add_export(CLI::App& app, std::vector<std::string>& formats) {
  add(app, kResults, "--export", formats, "FORMAT",
      "Robot program too: krl, rapid, ls, trajectory_msgs or moveit; several with commas, or the "
      "option again")
      .allow_extra_args(false);
}

void add_chain(CLI::App& app, std::string& base, std::string& part, std::string& tip,
               std::filesystem::path& limits) {
  add(app, kRobot, "--base", base, "LINK", "Base link; default: the root");
  add(app, kRobot, "--part", part, "LINK", "Link of the part; default: the base link");
  add(app, kRobot, "--tip", tip, "LINK", "Tip link; default: of the longest chain");
  add(app, kRobot, "--limits", limits, "FILE", "Joint limits (YAML); default: the URDF's");
}

}  // namespace

void add_arguments(CLI::App& app, PlanCommand& command) {
  add_problem(app, command.problem);
  add(app, kWhat, "--mode", command.mode, "MODE", "two-stage (default) or graph-only")
      .check(CLI::IsMember({"two-stage", "graph-only"}));
  add_out(app, command.out, "out/<problem>");
  add_export(app, command.exports);
  add_no_report(app, command.no_report);
  add_plot(app, command.plot);
}

void add_arguments(CLI::App& app, SmoothCommand& command) {
  add(app, kWhat, "PROBLEM", command.problem, "FILE",
      "Problem file (YAML); or --urdf and --keep instead");
  add(app, kWhat, "--joints", command.joints, "FILE",
      "Joint path (CSV, YAML of ROS) or program (.src, .mod, .ls) to smooth")
      .required();
  add(app, kWhat, "--smoothing-time", command.smoothing_time, "TIME",
      "Time to smooth over, s; default: the problem's, or by the path");
  const char* robot = "Robot, without a problem";
  add(app, robot, "--urdf", command.urdf, "FILE", "Robot description (URDF)");
  add(app, robot, "--base", command.base_link, "LINK", "Base link; default: the root");
  add(app, robot, "--part", command.part_link, "LINK", "Link of the part; default: the base link");
  add(app, robot, "--tip", command.tip_link, "LINK", "Tip link; default: of the longest chain");
  add(app, robot, "--limits", command.limits, "FILE", "Joint limits (YAML); default: the URDF's");
  add(app, robot, "--keep", command.keep, "LENGTH,ANGLE",
      "How far the TCP may be moved and turned, such as 0.5mm,0.5deg");
  add_flag(app, robot, "--no-self-collision", command.no_self_collision,
           "Don't keep the links clear of each other, don't read their meshes");
  add_out(app, command.out, "out/<problem> or out/<joint path>");
  add_export(app, command.exports);
  add_no_report(app, command.no_report);
  add_plot(app, command.plot);
}

void add_arguments(CLI::App& app, CheckCommand& command) {
  add_problem(app, command.problem);
  add(app, kWhat, "TRAJECTORY", command.trajectory, "FILE", "Trajectory (CSV)").required();
  add_flag(app, kResults, "--json", command.json, "Print the verification as JSON");
}

void add_arguments(CLI::App& app, CompareCommand& command) {
  add_problem(app, command.problem);
  add_out(app, command.out, "out/<problem>");
  add_no_report(app, command.no_report);
  add_plot(app, command.plot);
}

void add_arguments(CLI::App& app, PlaceCommand& command) {
  add_problem(app, command.problem);
  add_out(app, command.out, "out/<problem>");
}

void add_arguments(CLI::App& app, InfoCommand& command) {
  add(app, kWhat, "ROBOT", command.urdf, "FILE", "Robot description (URDF)").required();
  add_chain(app, command.base_link, command.part_link, command.tip_link, command.limits);
  add(app, kRobot, "--srdf", command.srdf, "FILE", "SRDF, for --group and disabled pairs");
  add(app, kRobot, "--group", command.group, "NAME", "Group of the SRDF: gives base and tip");
  add(app, kRobot, "--package", command.packages, "DIR",
      "Folder for package://, before ROS_PACKAGE_PATH; may be repeated")
      .allow_extra_args(false);
  add(app, kRobot, "--collision-from", command.collision_from, "SHAPES",
      "collision (default), or visual: links without collision shapes take their visual ones")
      .check(CLI::IsMember({"collision", "visual"}));
}

void add_arguments(CLI::App& app, NewCommand& command) {
  add(app, kWhat, "FILE", command.file, "FILE", "Problem file to write (YAML); -: print it")
      .required();
  add_flag(app, kWhat, "--force", command.force, "Overwrite a file that is there");
  add(app, kRobot, "--robot", command.urdf, "FILE",
      "Robot description (URDF); default: the KUKA KR 5 arc that ships");
  add_chain(app, command.base_link, command.part_link, command.tip_link, command.limits);
  add(app, kSeam, "--seam", command.seam, "KIND",
      "line (default), arc, or csv: poses in a file of their own beside it")
      .check(CLI::IsMember({"line", "arc", "csv"}));
}

}  // namespace wristwise::app
