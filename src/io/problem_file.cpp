#include "io/problem_sections.hpp"
#include "wristwise/error.hpp"
#include "wristwise/problem.hpp"

namespace wristwise {

namespace {

constexpr const char* kCacheFolder = ".wristwise_cache";

double read_controller_period(const ConfigReader& reader) {
  reader.expect_keys({"period"});
  const auto period = reader.find("period");
  return period ? period->positive(Quantity::time) : Problem().controller_period;
}

/// That carries the part; empty: the base link.
std::string read_part_link(const ConfigReader& path) {
  const auto link = path.find("link");
  return link ? link->text() : std::string();
}

}  // namespace

ProblemSections read_problem(const std::filesystem::path& file, const LoadOptions& options) {
  const ConfigNode root = read_yaml(file);
  const ConfigReader reader(root, file);
  reader.expect_keys(
      {"robot", "scene", "path", "cost", "graph", "refine", "controller", "placement", "export"});

  ProblemSections sections;
  Problem& problem = sections.problem;
  problem.name = file.stem().string();
  const ConfigReader path = reader.at("path");
  std::filesystem::path cache;
  if (options.mesh_cache) cache = file.parent_path() / kCacheFolder;
  RobotSection robot = read_robot(reader.at("robot"), read_part_link(path), cache);
  problem.robot = std::move(robot.robot);
  problem.inverse_kinematics = std::move(robot.inverse_kinematics);
  problem.scene = read_scene(reader.find("scene"), *problem.robot, robot.packages, cache);
  if (robot.disabled) {
    problem.scene.disabled = std::move(*robot.disabled);
    problem.scene.find_permanent_contacts = false;
  }
  if (const auto exports = reader.find("export"))
    problem.exports = read_export(*exports, *problem.robot);
  sections.path = read_path(path, *problem.robot, problem.exports);
  problem.task = task_after(Pose::Identity(), sections.path, *problem.robot);
  if (const auto cost = reader.find("cost")) problem.cost = read_cost(*cost, *problem.robot);
  if (const auto graph = reader.find("graph")) problem.graph = read_graph(*graph, *problem.robot);
  if (const auto refine = reader.find("refine")) problem.refine = read_refine(*refine);
  if (const auto controller = reader.find("controller"))
    problem.controller_period = read_controller_period(*controller);
  if (const auto placement = reader.find("placement"))
    sections.placement = read_placement(*placement, problem.scene);
  problem.files = reader.files();
  return sections;
}

Problem load_problem(const std::filesystem::path& file, const LoadOptions& options) {
  return read_problem(file, options).problem;
}

PlacementRequest load_placement(const std::filesystem::path& file, const LoadOptions& options) {
  ProblemSections sections = read_problem(file, options);
  if (!sections.placement)
    throw InvalidInput(file.string(), "the section 'placement' is missing",
                       "placement: {move: part, with: all, x: 0.1, y: 0.1} or the like");
  PlacementRequest request;
  request.part_frame = sections.path.part;
  request.options = std::move(*sections.placement);
  request.task_after = [path = std::move(sections.path), robot = sections.problem.robot](
                           const Pose& motion) { return task_after(motion, path, *robot); };
  request.problem = std::move(sections.problem);
  return request;
}

}  // namespace wristwise
