#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "io/coordinate_keys.hpp"
#include "io/problem_sections.hpp"

namespace wristwise {

namespace {

void read_weight(const ConfigReader& reader, const std::string& key, double& weight) {
  if (const auto value = reader.find(key)) weight = value->not_negative(Quantity::number);
}

/// By name, those left out being 1; or a list.
std::vector<double> read_joint_weights(const ConfigReader& reader, const Robot& robot) {
  const auto count = static_cast<std::size_t>(robot.joint_count());
  if (reader.is_map()) {
    reader.expect_keys(robot.joint_names());
    std::vector<double> weights(count, 1);
    for (std::size_t j = 0; j < count; ++j)
      if (const auto weight = reader.find(robot.joints()[j].name))
        weights[j] = weight->positive(Quantity::number);
    return weights;
  }
  std::vector<double> weights;
  for (const ConfigReader& item :
       reader.items(count, fmt::format("a list of {}, one per joint, or {{joint: weight}}", count)))
    weights.push_back(item.positive(Quantity::number));
  return weights;
}

void read_singularity(const ConfigReader& reader, CostOptions& cost) {
  reader.expect_keys({"graph", "refine", "measure"});
  read_weight(reader, "graph", cost.singularity_graph);
  read_weight(reader, "refine", cost.singularity_refine);
  if (const auto measure = reader.find("measure")) {
    cost.singularity_measure = measure->choice({"wrist", "manipulability"}) == "wrist"
                                   ? SingularityMeasure::wrist
                                   : SingularityMeasure::manipulability;
  }
}

void read_posture(const ConfigReader& reader, const Robot& robot, CostOptions& cost) {
  reader.expect_keys({"joints", "weight"});
  const auto count = static_cast<std::size_t>(robot.joint_count());
  const auto items =
      reader.at("joints").items(count, fmt::format("a list of {}, one per joint", count));
  for (std::size_t j = 0; j < count; ++j)
    cost.preferred_posture.push_back(items[j].quantity(joint_quantity(robot, j)));
  read_weight(reader, "weight", cost.posture);
}

/// A limit that may be `off`.
void read_limit(const ConfigReader& reader, const std::string& key, Quantity quantity,
                double& limit) {
  const auto value = reader.find(key);
  if (!value) return;
  limit =
      value->is_word("off") ? std::numeric_limits<double>::infinity() : value->positive(quantity);
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
  const std::vector<std::string> of_tolerance = keys;
  for (const std::string& joint : robot.joint_names()) keys.push_back(joint);
  reader.expect_keys(keys);
  for (int i = 0; i < 6; ++i)
    if (const auto value = find_coordinate(reader, i))
      graph.step[i] = value->positive(coordinate_quantity(i));
  if (const auto joints = reader.find("joints"))
    graph.joint_step = read_joint_steps(*joints, robot);
  for (std::size_t j = 0; j < robot.joints().size(); ++j) {
    const std::string& name = robot.joints()[j].name;
    if (std::find(of_tolerance.begin(), of_tolerance.end(), name) != of_tolerance.end()) continue;
    if (const auto step = reader.find(name))
      graph.redundancy[name] = step->positive(joint_quantity(robot, j));
  }
}

}  // namespace

CostOptions read_cost(const ConfigReader& reader, const Robot& robot) {
  reader.expect_keys({"joint_motion", "acceleration", "jerk", "euler", "position", "joint_weights",
                      "steps", "singularity", "posture"});
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
  if (const auto position = reader.find("position")) {
    position->expect_keys({"graph", "refine"});
    read_weight(*position, "graph", cost.position_graph);
    read_weight(*position, "refine", cost.position_refine);
  }
  if (const auto steps = reader.find("steps"))
    cost.squared_steps = steps->choice({"absolute", "squared"}) == "squared";
  if (const auto singularity = reader.find("singularity")) read_singularity(*singularity, cost);
  if (const auto posture = reader.find("posture")) read_posture(*posture, robot, cost);
  if (const auto weights = reader.find("joint_weights"))
    cost.joint_weights = read_joint_weights(*weights, robot);
  return cost;
}

GraphOptions read_graph(const ConfigReader& reader, const Robot& robot) {
  reader.expect_keys({"samples", "automatic_samples", "coarse_to_fine", "turns", "max_stray",
                      "check_moves", "max_tcp_step", "max_tcp_turn", "collision_checks", "planner",
                      "sparse_deviation", "seeds", "spare_seeds", "seed_separation",
                      "try_relaxations"});
  GraphOptions graph;
  if (const auto samples = reader.find("samples")) read_samples(*samples, robot, graph);
  if (const auto turns = reader.find("turns"))
    graph.turns = turns->choice({"all", "principal"}) == "all" ? Turns::all : Turns::principal;
  if (const auto samples = reader.find("automatic_samples")) {
    if (reader.find("samples")) samples->fail("samples are given too", "one of the two");
    graph.automatic_samples = samples->whole_number(1);
    if (graph.automatic_samples > 1000000) samples->fail("too many", "at most a million");
  }
  if (const auto finer = reader.find("coarse_to_fine"))
    graph.coarse_to_fine = finer->choice({"true", "false"}) == "true";
  if (const auto relax = reader.find("try_relaxations"))
    graph.try_relaxations = relax->choice({"true", "false"}) == "true";
  read_limit(reader, "max_stray", Quantity::length, graph.max_stray);
  if (const auto check = reader.find("check_moves"))
    graph.check_moves = check->choice({"true", "false"}) == "true";
  read_limit(reader, "max_tcp_step", Quantity::length, graph.max_tcp_step);
  read_limit(reader, "max_tcp_turn", Quantity::angle, graph.max_tcp_turn);
  if (const auto checks = reader.find("collision_checks"))
    graph.collision_checks = checks->choice({"lazy", "eager"}) == "lazy" ? CollisionChecks::lazy
                                                                         : CollisionChecks::eager;
  if (const auto planner = reader.find("planner"))
    graph.planner =
        planner->choice({"dense", "sparse"}) == "dense" ? Planner::dense : Planner::sparse;
  if (const auto deviation = reader.find("sparse_deviation"))
    graph.sparse_deviation = deviation->positive(Quantity::angle);
  if (const auto seeds = reader.find("seeds")) graph.seeds = seeds->whole_number(1);
  if (const auto spare = reader.find("spare_seeds")) graph.spare_seeds = spare->whole_number(0);
  if (const auto separation = reader.find("seed_separation"))
    graph.seed_separation = separation->positive(Quantity::angle);
  return graph;
}

RefineOptions read_refine(const ConfigReader& reader) {
  reader.expect_keys({"smoothing_time", "knot_spacing", "max_rounds", "max_iterations",
                      "constraint_tolerance", "clearance_epsilon", "try_speeds", "time_limit"});
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
  if (const auto value = reader.find("try_speeds"))
    refine.try_speeds = value->choice({"true", "false"}) == "true";
  read_limit(reader, "time_limit", Quantity::time, refine.time_limit);
  return refine;
}

}  // namespace wristwise
