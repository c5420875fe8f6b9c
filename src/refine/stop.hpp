#pragma once

#include <chrono>
#include <limits>

#include "cancelled.hpp"

namespace wristwise {

/// When an optimisation is to end early: the caller cancels, or its time is up.
class Stop {
 public:
  /// @param time_limit s from now; infinity: none
  explicit Stop(const Monitor& monitor, double time_limit = std::numeric_limits<double>::infinity())
      : monitor_(monitor), time_limit_(time_limit) {}

  bool requested() const { return monitor_.cancelled() || time_is_up(); }

 private:
  bool time_is_up() const {
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start_;
    return passed.count() > time_limit_;
  }

  const Monitor& monitor_;
  double time_limit_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace wristwise
