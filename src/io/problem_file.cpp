#include "io/problem_sections.hpp"
#include "wristwise/error.hpp"
#include "wristwise/problem.hpp"

namespace wristwise {

namespace {

double read_controller_period(const ConfigReader& reader) {
  reader.expect_keys({"period"});
  const auto period = reader.find("period");
  return period ? period->positive(Quantity::time) : Problem().controller_period;
}

}  // namespace

Problem load_problem(const std::filesystem::path& file) {
  const ConfigNode root = read_yaml(file);
  const ConfigReader reader(root, file);
  reader.expect_keys({"robot", "scene", "path", "cost", "graph", "refine", "controller"});

  Problem problem;
  problem.name = file.stem().string();
  RobotSection robot = read_robot(reader.at("robot"));
  problem.robot = std::move(robot.robot);
  problem.scene = read_scene(reader.find("scene"), *problem.robot, robot.packages);
  if (robot.disabled) {
    problem.scene.disabled = std::move(*robot.disabled);
    problem.scene.find_permanent_contacts = false;
  }
  problem.task = read_task(reader.at("path"), *problem.robot);
  if (const auto cost = reader.find("cost")) problem.cost = read_cost(*cost, *problem.robot);
  if (const auto graph = reader.find("graph")) problem.graph = read_graph(*graph, *problem.robot);
  if (const auto refine = reader.find("refine")) problem.refine = read_refine(*refine);
  if (const auto controller = reader.find("controller"))
    problem.controller_period = read_controller_period(*controller);
  problem.files = reader.files();
  return problem;
}

}  // namespace wristwise
