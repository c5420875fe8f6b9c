#include "io/problem_sections.hpp"
#include "kinematics/robot_files.hpp"
#include "kinematics/urdf_collision.hpp"
#include "wristwise/error.hpp"
#include "wristwise/ikfast_inverse_kinematics.hpp"
#include "wristwise/urdf.hpp"

namespace wristwise {

std::filesystem::path find_file(const ConfigReader& reader, const Packages& packages) {
  const std::string uri = reader.text();
  if (uri.rfind("package://", 0) != 0) return reader.existing_file();
  const std::filesystem::path file = resolve_mesh(uri, {{}, packages}, reader.where());
  reader.uses_file(file);
  return file;
}

namespace {

/// The free parameters of the solver: {joint: step}.
IkFastInverseKinematics::FreeSteps read_free_steps(const ConfigReader& reader, const Robot& robot) {
  std::vector<std::string> names;
  for (const Joint& joint : robot.joints()) names.push_back(joint.name);
  reader.expect_keys(names);
  IkFastInverseKinematics::FreeSteps steps;
  for (std::size_t j = 0; j < names.size(); ++j) {
    if (const auto step = reader.find(names[j]))
      steps[names[j]] = step->positive(joint_quantity(robot, j));
  }
  return steps;
}

std::shared_ptr<const InverseKinematics> read_ik(const ConfigReader& reader,
                                                 const std::shared_ptr<const Robot>& robot,
                                                 const Packages& packages) {
  reader.expect_keys({"ikfast", "free"});
  const ConfigReader library = reader.at("ikfast");
  IkFastInverseKinematics::FreeSteps steps;
  if (const auto free = reader.find("free")) steps = read_free_steps(*free, *robot);
  const std::filesystem::path file = find_file(library, packages);
  try {
    return IkFastInverseKinematics::load(robot, file, steps);
  } catch (const InvalidInput& error) {
    throw InvalidInput(library.where(), error.what());
  }
}

}  // namespace

RobotSection read_robot(const ConfigReader& reader) {
  reader.expect_keys({"urdf", "base_link", "tip_link", "tool", "limits", "srdf", "packages", "ik"});
  RobotSource source;
  if (const auto packages = reader.find("packages"))
    for (const ConfigReader& folder : packages->items())
      source.packages.push_back(folder.relative_path());
  source.urdf = find_file(reader.at("urdf"), source.packages);
  if (const auto base = reader.find("base_link")) source.base_link = base->text();
  if (const auto tip = reader.find("tip_link")) source.tip_link = tip->text();
  if (const auto tool = reader.find("tool")) source.tool = read_pose(*tool);
  if (const auto limits = reader.find("limits"))
    source.limits = find_file(*limits, source.packages);

  RobotSection section;
  section.packages = source.packages;
  section.robot = std::make_shared<const Robot>(load_robot(source));
  for (const std::filesystem::path& file : robot_files(source)) reader.uses_file(file);
  if (const auto ik = reader.find("ik"))
    section.inverse_kinematics = read_ik(*ik, section.robot, source.packages);
  if (const auto srdf = reader.find("srdf"))
    section.disabled = load_disabled_collisions(find_file(*srdf, source.packages));
  return section;
}

Quantity joint_quantity(const Robot& robot, std::size_t joint) {
  return robot.joints()[joint].type == JointType::prismatic ? Quantity::length : Quantity::angle;
}

}  // namespace wristwise
