#include "placement/placement_trials.hpp"

#include "cancelled.hpp"

namespace wristwise {

PlacementTrials::PlacementTrials(const PlacementMeter& meter, const Monitor& monitor,
                                 double time_limit)
    : meter_(meter), monitor_(monitor), time_limit_(time_limit) {}

void PlacementTrials::begin(const std::string& stage, std::size_t expected) {
  stage_ = stage;
  expected_ = expected;
  done_ = 0;
  monitor_.report(stage_, 0);
}

Placement PlacementTrials::measure(const Offset& offset, int worker) {
  throw_if_cancelled(monitor_);
  if (out_of_time()) throw OutOfTime{};
  Placement placement{offset, meter_(offset)};
  const std::size_t done = ++done_;
  if (worker == 0 && expected_ > 0)
    monitor_.report(stage_, static_cast<double>(done) / static_cast<double>(expected_));
  return placement;
}

bool PlacementTrials::out_of_time() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count() >
         time_limit_;
}

}  // namespace wristwise
