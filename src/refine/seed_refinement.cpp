#include "refine/seed_refinement.hpp"

#include <utility>

#include "cancelled.hpp"
#include "parallel.hpp"

namespace wristwise {

namespace {

/// Cancelled before there is a motion, it does not take those of the other seeds with it.
Refined refine_or_stop(const RefinementInput& input, const JointPath& seed) {
  try {
    return refine(input, seed);
  } catch (const Cancelled&) {
    Refined none;
    none.stopped = true;
    none.statistics.termination = "stopped";
    return none;
  }
}

}  // namespace

Refined refine_seeds(const RefinementInput& input, std::vector<Seed>& seeds, int threads) {
  std::vector<Refined> refined(seeds.size());
  Monitor silent;
  silent.cancel = input.monitor.cancel;
  parallel_for(seeds.size(), threads, [&](int worker, std::size_t i) {
    const RefinementInput own{input.robot, input.task,    input.clearance,
                              input.cost,  input.options, worker == 0 ? input.monitor : silent};
    refined[i] = refine_or_stop(own, seeds[i].path);
  });
  std::size_t best = 0;
  bool stopped = false;
  for (std::size_t i = 0; i < seeds.size(); ++i) {
    const Refined& outcome = refined[i];
    seeds[i].refinement = outcome.statistics.termination;
    if (outcome.feasible) seeds[i].objective = outcome.statistics.objective;
    if (is_better(outcome, refined[best])) best = i;
    stopped = stopped || outcome.stopped;
  }
  if (!refined[best].feasible) throw_if_cancelled(input.monitor);
  refined[best].stopped = stopped;
  return std::move(refined[best]);
}

}  // namespace wristwise
