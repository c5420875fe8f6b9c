#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <memory>

#include "app/commands.hpp"
#include "app/exit_code.hpp"
#include "app/joint_unit.hpp"
#include "app/output.hpp"
#include "app/required_file.hpp"
#include "app/text_table.hpp"
#include "wristwise/error.hpp"
#include "wristwise/inverse_kinematics.hpp"
#include "wristwise/urdf.hpp"

namespace wristwise::app {

namespace {

const char* type_name(JointType type) {
  switch (type) {
    case JointType::revolute:
      return "revolute";
    case JointType::continuous:
      return "continuous";
    case JointType::prismatic:
      break;
  }
  return "prismatic";
}

std::string limit_text(double value) { return std::isfinite(value) ? short_number(value) : "-"; }

std::string joint_table(const Robot& robot) {
  std::vector<TableRow> rows = {
      {"joint", "type", "unit", "lower", "upper", "velocity", "accel.", "jerk"}};
  for (const Joint& joint : robot.joints())
    rows.push_back({joint.name, type_name(joint.type), joint_unit(joint), limit_text(joint.lower),
                    limit_text(joint.upper), limit_text(joint.max_velocity),
                    limit_text(joint.max_acceleration), limit_text(joint.max_jerk)});
  return aligned(rows);
}

std::string body_table(const Robot& robot) {
  std::vector<TableRow> rows = {{"link", "moved by", "collision shapes"}};
  for (const Link& link : robot.links())
    rows.push_back(
        {link.name,
         link.joint < 0 ? "-" : robot.joints()[static_cast<std::size_t>(link.joint)].name,
         fmt::format("{}", link.collision.size())});
  return aligned(rows);
}

}  // namespace

int run_info(const InfoCommand& command, const Settings& settings) {
  require_file(command.urdf, "a robot description", ".urdf");
  if (!command.group.empty() && command.srdf.empty())
    throw InvalidInput("--group", "there is no SRDF to look it up in", "--srdf FILE");
  RobotSource source;
  source.urdf = command.urdf;
  source.base_link = command.base_link;
  source.part_link = command.part_link;
  source.tip_link = command.tip_link;
  source.limits = command.limits;
  source.srdf = command.srdf;
  source.group = command.group;
  source.packages = command.packages;
  source.visual_as_collision = command.collision_from == "visual";
  source.require_velocity_limits = false;
  const auto robot = std::make_shared<const Robot>(load_robot(source));
  const InverseKinematicsFound found = find_redundant_inverse_kinematics(robot);
  const bool part_stands_still = robot->part_link() == robot->base_link();
  const Paint paint(settings.colour, STDOUT_FILENO);
  std::string text =
      fmt::format("{}: {} to {}, {} joints\n{}{} {}\n{}{}\n{}", paint.bold(robot->name()),
                  robot->part_link(), robot->tip_link(), robot->joint_count(), joint_table(*robot),
                  paint.bold("inverse kinematics:"), found.description, paint.bold("bodies"),
                  part_stands_still ? "" : fmt::format(", seen from {}", robot->part_link()),
                  body_table(*robot));
  for (const std::string& warning : robot->warnings())
    text += paint.warning("warning:") + " " + warning + "\n";
  print(text);
  return kSolved;
}

}  // namespace wristwise::app
