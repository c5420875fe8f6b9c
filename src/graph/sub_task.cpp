#include "graph/sub_task.hpp"

#include <numeric>

namespace wristwise {

SubTask sub_task(const Task& whole, const CostOptions& cost,
                 const std::vector<std::size_t>& waypoints) {
  SubTask part{whole, cost};
  part.task.waypoints.clear();
  for (const std::size_t i : waypoints) part.task.waypoints.push_back(whole.waypoints[i]);
  if (cost.vertex_cost) {
    part.cost.vertex_cost = [own = cost.vertex_cost, waypoints](std::size_t i,
                                                                const JointVector& q) {
      return own(waypoints[i], q);
    };
  }
  if (cost.edge_cost) {
    part.cost.edge_cost = [own = cost.edge_cost, waypoints](std::size_t i, const JointVector& from,
                                                            const JointVector& to) {
      return own(waypoints[i], from, to);
    };
  }
  return part;
}

SubTask sub_task(const Task& whole, const CostOptions& cost, std::size_t first, std::size_t last) {
  std::vector<std::size_t> waypoints(last - first);
  std::iota(waypoints.begin(), waypoints.end(), first);
  return sub_task(whole, cost, waypoints);
}

}  // namespace wristwise
