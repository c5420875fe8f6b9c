#include "graph/reachable_pieces.hpp"

#include "cancelled.hpp"
#include "graph/sub_task.hpp"

namespace wristwise {

std::vector<std::pair<std::size_t, std::size_t>> reachable_pieces(const SamplingInput& input,
                                                                  const Task& task,
                                                                  std::size_t reached,
                                                                  double epsilon, int threads,
                                                                  const Monitor& monitor) {
  const SampledPath sampled = sample_path(input, task, threads, {});
  const Monitor quiet;
  std::vector<std::pair<std::size_t, std::size_t>> pieces;
  if (reached > 1) pieces.emplace_back(0, reached - 1);
  for (std::size_t start = reached; start < task.waypoints.size();) {
    throw_if_cancelled(monitor);
    std::vector<Rung> rungs;
    for (std::size_t i = start; i < task.waypoints.size() && sampled.rungs[i].size() > 0; ++i) {
      rungs.push_back(sampled.rungs[i]);
    }
    std::size_t count = 0;
    if (!rungs.empty()) {
      const SubTask rest = sub_task(task, input.cost, start, start + rungs.size());
      const SamplingInput own{input.robot, input.ik, input.clearance, rest.cost, input.options};
      GraphSearch search(own, rest.task, epsilon, threads, quiet);
      count = search.find_path(rungs).positions.size();
    }
    if (count > 1) pieces.emplace_back(start, start + count - 1);
    start += count > 0 ? count : 1;
  }
  return pieces;
}

}  // namespace wristwise
