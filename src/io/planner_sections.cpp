#include <fmt/format.h>

#include <limits>

#include "io/coordinate_keys.hpp"
#include "io/problem_sections.hpp"

namespace wristwise {

namespace {

void read_weight(const ConfigReader& reader, const std::string& key, double& weight) {
  if (const auto value = reader.find(key)) weight = value->not_negative(Quantity::number);
}

std::vector<double> read_joint_weights(const ConfigReader& reader, const Robot& robot) {
  const auto count = static_cast<std::size_t>(robot.joint_count());
  std::vector<double> weights;
  for (const ConfigReader& item :
       reader.items(count, fmt::format("a list of {}, one per joint", count)))
    weights.push_back(item.positive(Quantity::number));
  return weights;
}

/// One step for all joints, or a list.
std::vector<double> read_joint_steps(const ConfigReader& reader, const Robot& robot) {
  const auto count = static_cast<std::size_t>(robot.joint_count());
  std::vector<ConfigReader> steps(count, reader);
  if (reader.is_list())
    steps = reader.items(count, fmt::format("a step or a list of {}, one per joint", count));
  std::vector<double> result;
  for (std::size_t j = 0; j < count; ++j)
    result.push_back(steps[j].not_negative(joint_quantity(robot, j)));
  return result;
}

void read_samples(const ConfigReader& reader, const Robot& robot, GraphOptions& graph) {
  std::vector<std::string> keys = coordinate_keys();
  keys.emplace_back("joints");
  reader.expect_keys(keys);
  for (int i = 0; i < 6; ++i)
    if (const auto value = find_coordinate(reader, i))
      graph.step[i] = value->positive(coordinate_quantity(i));
  if (const auto joints = reader.find("joints"))
    graph.joint_step = read_joint_steps(*joints, robot);
}

}  // namespace

CostOptions read_cost(const ConfigReader& reader, const Robot& robot) {
  reader.expect_keys({"joint_motion", "acceleration", "jerk", "euler", "joint_weights"});
  CostOptions cost;
  read_weight(reader, "joint_motion", cost.joint_motion);
  read_weight(reader, "acceleration", cost.acceleration);
  read_weight(reader, "jerk", cost.jerk);
  if (const auto euler = reader.find("euler")) {
    euler->expect_keys({"graph", "refine", "eta"});
    read_weight(*euler, "graph", cost.euler_graph);
    read_weight(*euler, "refine", cost.euler_refine);
    read_weight(*euler, "eta", cost.euler_eta);
  }
  if (const auto weights = reader.find("joint_weights"))
    cost.joint_weights = read_joint_weights(*weights, robot);
  return cost;
}

GraphOptions read_graph(const ConfigReader& reader, const Robot& robot) {
  reader.expect_keys({"samples", "turns", "max_stray", "planner"});
  GraphOptions graph;
  if (const auto samples = reader.find("samples")) read_samples(*samples, robot, graph);
  if (const auto turns = reader.find("turns"))
    graph.turns = turns->choice({"all", "principal"}) == "all" ? Turns::all : Turns::principal;
  if (const auto stray = reader.find("max_stray")) {
    graph.max_stray = stray->is_word("off") ? std::numeric_limits<double>::infinity()
                                            : stray->positive(Quantity::length);
  }
  if (const auto planner = reader.find("planner")) planner->choice({"dense"});
  return graph;
}

RefineOptions read_refine(const ConfigReader& reader) {
  reader.expect_keys({"smoothing_time", "knot_spacing", "max_rounds", "max_iterations",
                      "constraint_tolerance", "clearance_epsilon"});
  RefineOptions refine;
  if (const auto value = reader.find("smoothing_time"))
    refine.smoothing_time = value->positive(Quantity::time);
  if (const auto value = reader.find("knot_spacing"))
    refine.knot_spacing = value->not_negative(Quantity::time);
  if (const auto value = reader.find("max_rounds")) refine.max_rounds = value->whole_number(1);
  if (const auto value = reader.find("max_iterations"))
    refine.max_iterations = value->whole_number(1);
  if (const auto value = reader.find("constraint_tolerance"))
    refine.constraint_tolerance = value->positive(Quantity::number);
  if (const auto value = reader.find("clearance_epsilon"))
    refine.clearance_epsilon = value->positive(Quantity::length);
  return refine;
}

}  // namespace wristwise
