#include "export/controller_axes.hpp"
#include "io/text_file.hpp"
#include "wristwise/error.hpp"
#include "wristwise/robot_program.hpp"

namespace wristwise {

namespace {

std::string file_name(ProgramFormat format, const Problem& problem) {
  const std::string given = problem.exports.name.empty() ? problem.name : problem.exports.name;
  const std::string name = program_name(format, given);
  switch (format) {
    case ProgramFormat::krl:
      return name + ".src";
    case ProgramFormat::rapid:
      return name + ".mod";
    case ProgramFormat::ls:
      return name + ".ls";
    case ProgramFormat::trajectory_msgs:
      return "joint_trajectory.yaml";
    case ProgramFormat::moveit:
      break;
  }
  return "robot_trajectory.yaml";
}

std::string program_text(ProgramFormat format, const PlanResult& result, const Problem& problem) {
  switch (format) {
    case ProgramFormat::krl:
      return krl_text(robot_program(result, problem), problem);
    case ProgramFormat::rapid:
      return rapid_text(robot_program(result, problem), problem);
    case ProgramFormat::ls:
      return ls_text(robot_program(result, problem), problem);
    case ProgramFormat::trajectory_msgs:
      return joint_trajectory_text(result, problem);
    case ProgramFormat::moveit:
      break;
  }
  return robot_trajectory_text(result, problem);
}

}  // namespace

std::string format_name(ProgramFormat format) {
  switch (format) {
    case ProgramFormat::krl:
      return "krl";
    case ProgramFormat::rapid:
      return "rapid";
    case ProgramFormat::ls:
      return "ls";
    case ProgramFormat::trajectory_msgs:
      return "trajectory_msgs";
    case ProgramFormat::moveit:
      break;
  }
  return "moveit";
}

const std::vector<ProgramFormat>& program_formats() {
  static const std::vector<ProgramFormat> formats = {
      ProgramFormat::krl, ProgramFormat::rapid, ProgramFormat::ls, ProgramFormat::trajectory_msgs,
      ProgramFormat::moveit};
  return formats;
}

void check_export(ProgramFormat format, const Problem& problem) {
  if (format == ProgramFormat::trajectory_msgs || format == ProgramFormat::moveit) return;
  const ControllerAxes axes(*problem.robot, problem.exports.axes);
}

std::filesystem::path write_program(ProgramFormat format, const std::filesystem::path& folder,
                                    const PlanResult& result, const Problem& problem) {
  std::filesystem::path file = folder / file_name(format, problem);
  std::filesystem::remove(file);
  if (result.status != Status::solved) return {};
  write_text(file, program_text(format, result, problem));
  return file;
}

}  // namespace wristwise
