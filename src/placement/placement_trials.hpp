#pragma once

#include <atomic>
#include <chrono>
#include <map>
#include <string>

#include "placement/placement_measure.hpp"

namespace wristwise {

/// Thrown where the time limit of the search is over.
struct OutOfTime {};

/// Measures placements within a time limit, and tells how far that has come. Shared by threads.
class PlacementTrials {
 public:
  PlacementTrials(const PlacementMeter& meter, const Monitor& monitor, double time_limit);

  /// The next stage of `expected` placements at most.
  void begin(const std::string& stage, std::size_t expected);

  /// @param worker 0: the calling thread, which reports
  /// @throws Cancelled, OutOfTime
  Placement measure(const Offset& offset, int worker);

  bool out_of_time() const;

 private:
  const PlacementMeter& meter_;
  const Monitor& monitor_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  double time_limit_;
  std::string stage_;
  std::size_t expected_ = 0;
  std::atomic<std::size_t> done_{0};
};

/// What became of the placements: reason -> how many; "" where one is feasible.
using ObstacleCounts = std::map<std::string, std::size_t>;

}  // namespace wristwise
