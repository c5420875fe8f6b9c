#include "io/json_graph.hpp"

#include <nlohmann/json.hpp>

namespace wristwise::json {

namespace {

Json seeds(const PlanResult& result) {
  Json json = Json::array();
  for (const Seed& seed : result.seeds) {
    json.push_back({{"cost", number(seed.cost)},
                    {"differs_at", seed.differs_at},
                    {"refinement", seed.refinement},
                    {"objective", number(seed.objective)}});
  }
  return json;
}

}  // namespace

Json graph(const PlanResult& result) {
  const GraphStatistics& graph = result.graph;
  return {{"vertices", graph.vertices},
          {"edges", count(graph.edges)},
          {"edges_evaluated", count(graph.edges_evaluated)},
          {"collision_checks", graph.collision_checks},
          {"cost", number(graph.cost)},
          {"joint_motion_l1", number(graph.joint_motion_l1)},
          {"edges_checked", graph.edges_checked},
          {"edges_checked_if_eager", count(graph.edges_if_eager)},
          {"postures", graph.postures},
          {"postures_checked", graph.postures_checked},
          {"postures_checked_if_eager", graph.postures},
          {"first_turns", graph.first_turns},
          {"last_turns", graph.last_turns},
          {"grid_rounds", graph.grid_rounds},
          {"first_cost", number(graph.first_cost)},
          {"sparse_points", graph.sparse_points},
          {"replans", graph.replans},
          {"pieces", graph.pieces},
          {"seeds", seeds(result)}};
}

}  // namespace wristwise::json
