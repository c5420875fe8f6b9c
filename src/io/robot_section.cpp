#include <fmt/format.h>

#include "io/problem_sections.hpp"
#include "kinematics/partial_chain.hpp"
#include "kinematics/robot_files.hpp"
#include "kinematics/urdf_collision.hpp"
#include "wristwise/error.hpp"
#include "wristwise/ikfast_inverse_kinematics.hpp"
#include "wristwise/urdf.hpp"

namespace wristwise {

namespace {

/// A value, or a range inside the joint's limits.
void read_joint_range(const ConfigReader& reader, Quantity quantity, Joint& joint) {
  double lower = 0, upper = 0;
  if (reader.is_list()) {
    const auto bounds = reader.items(2, "[lower, upper]");
    lower = bounds[0].quantity(quantity);
    upper = bounds[1].quantity(quantity);
  } else {
    lower = upper = reader.quantity(quantity);
  }
  if (lower > upper) reader.fail("the lower end is above the upper", "[lower, upper]");
  if (lower < joint.lower || upper > joint.upper)
    reader.fail(
        fmt::format("it leaves the joint's limits {:.6g} to {:.6g}", joint.lower, joint.upper),
        "a range inside them");
  joint.lower = lower;
  joint.upper = upper;
  if (joint.type == JointType::continuous) joint.type = JointType::revolute;
}

/// A joint with one value is held there, and is no joint of the chain any more.
Robot with_joint_ranges(const Robot& robot, const ConfigReader& reader) {
  Robot::Parts parts = robot.parts();
  std::vector<std::string> names;
  for (const Joint& joint : parts.joints) names.push_back(joint.name);
  reader.expect_keys(names);
  std::vector<int> held;
  for (std::size_t j = 0; j < parts.joints.size(); ++j) {
    const auto range = reader.find(names[j]);
    if (!range) continue;
    read_joint_range(*range, joint_quantity(robot, j), parts.joints[j]);
    if (parts.joints[j].lower == parts.joints[j].upper) held.push_back(static_cast<int>(j));
  }
  if (held.size() == names.size()) reader.fail("every joint is held", "one that moves");
  const Robot narrowed(std::move(parts));
  return held.empty() ? narrowed : with_held_joints(narrowed, held, narrowed.lower_limits());
}

}  // namespace

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
  const std::vector<std::string> names = robot.joint_names();
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

std::optional<double> read_convex_error(const ConfigReader& reader) {
  if (reader.is_word("off")) return std::nullopt;
  return reader.positive(Quantity::length);
}

RobotSection read_robot(const ConfigReader& reader, const std::string& part_link,
                        const std::filesystem::path& mesh_cache) {
  reader.expect_keys({"urdf", "base_link", "tip_link", "tool", "limits", "joint_ranges", "srdf",
                      "group", "packages", "collision_from", "convex_error", "ik"});
  RobotSource source;
  if (const auto packages = reader.find("packages"))
    for (const ConfigReader& folder : packages->items())
      source.packages.push_back(folder.relative_path());
  source.urdf = find_file(reader.at("urdf"), source.packages);
  if (const auto base = reader.find("base_link")) source.base_link = base->text();
  if (const auto tip = reader.find("tip_link")) source.tip_link = tip->text();
  source.part_link = part_link;
  if (const auto tool = reader.find("tool")) source.tool = read_pose(*tool);
  if (const auto limits = reader.find("limits"))
    source.limits = find_file(*limits, source.packages);
  if (const auto srdf = reader.find("srdf")) source.srdf = find_file(*srdf, source.packages);
  if (const auto group = reader.find("group")) {
    if (source.srdf.empty()) group->fail("there is no srdf to look it up in", "srdf: FILE");
    source.group = group->text();
  }
  if (const auto from = reader.find("collision_from"))
    source.visual_as_collision = from->choice({"collision", "visual"}) == "visual";
  if (const auto error = reader.find("convex_error"))
    source.meshes.convex_error = read_convex_error(*error);
  source.meshes.cache = mesh_cache;

  RobotSection section;
  section.packages = source.packages;
  Robot robot = load_robot(source);
  if (const auto ranges = reader.find("joint_ranges")) robot = with_joint_ranges(robot, *ranges);
  section.robot = std::make_shared<const Robot>(std::move(robot));
  for (const std::filesystem::path& file : robot_files(source)) reader.uses_file(file);
  if (const auto ik = reader.find("ik"))
    section.inverse_kinematics = read_ik(*ik, section.robot, source.packages);
  if (!source.srdf.empty())
    section.disabled = load_disabled_collisions(source.srdf, *section.robot);
  return section;
}

Quantity joint_quantity(const Robot& robot, std::size_t joint) {
  return robot.joints()[joint].type == JointType::prismatic ? Quantity::length : Quantity::angle;
}

}  // namespace wristwise
