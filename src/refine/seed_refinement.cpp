#include "refine/seed_refinement.hpp"

#include <utility>

#include "parallel.hpp"

namespace wristwise {

Refined refine_seeds(const RefinementInput& input, std::vector<Seed>& seeds, int threads) {
  std::vector<Refined> refined(seeds.size());
  Monitor silent;
  silent.cancel = input.monitor.cancel;
  parallel_for(seeds.size(), threads, [&](int worker, std::size_t i) {
    const RefinementInput own{input.robot, input.task,    input.clearance,
                              input.cost,  input.options, worker == 0 ? input.monitor : silent};
    refined[i] = refine(own, seeds[i].path);
  });
  std::size_t best = 0;
  for (std::size_t i = 0; i < seeds.size(); ++i) {
    const Refined& outcome = refined[i];
    seeds[i].refinement = outcome.statistics.termination;
    if (outcome.feasible) seeds[i].objective = outcome.statistics.objective;
    if (is_better(outcome, refined[best])) best = i;
  }
  return std::move(refined[best]);
}

}  // namespace wristwise
