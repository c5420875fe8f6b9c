#include "export/weld_stretches.hpp"

namespace wristwise {

std::vector<WeldStretch> weld_stretches(const Task& task) {
  std::vector<WeldStretch> stretches;
  for (std::size_t i = 0; i + 1 < task.waypoints.size(); ++i) {
    const Waypoint &from = task.waypoints[i], &to = task.waypoints[i + 1];
    if (!from.welding || !to.welding || !task.tolerance_between(i)) continue;
    if (!stretches.empty() && stretches.back().to == from.time)
      stretches.back().to = to.time;
    else
      stretches.push_back({from.time, to.time});
  }
  return stretches;
}

}  // namespace wristwise
