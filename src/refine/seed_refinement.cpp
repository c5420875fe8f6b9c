#include "refine/seed_refinement.hpp"

#include <string>
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

/// Of several seeds progress says which it is of: "refine seed 2 of 3".
Monitor monitor_of_seed(const Monitor& monitor, std::size_t seed, std::size_t count) {
  if (count < 2 || !monitor.progress) return monitor;
  Monitor own = monitor;
  own.progress =
      [&monitor, which = " seed " + std::to_string(seed + 1) + " of " + std::to_string(count)](
          const std::string& stage, double fraction) { monitor.report(stage + which, fraction); };
  return own;
}

}  // namespace

Refined refine_seeds(const RefinementInput& input, std::vector<Seed>& seeds, int threads) {
  std::vector<Refined> refined(seeds.size());
  Monitor silent;
  silent.cancel = input.monitor.cancel;
  parallel_for(seeds.size(), threads, [&](int worker, std::size_t i) {
    const Monitor monitor = worker == 0 ? monitor_of_seed(input.monitor, i, seeds.size()) : silent;
    const RefinementInput own{input.robot, input.task,    input.clearance,
                              input.cost,  input.options, monitor};
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
