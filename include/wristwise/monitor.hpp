#pragma once

#include <atomic>
#include <functional>
#include <string>

#include "wristwise/visibility.hpp"

namespace WRISTWISE_PUBLIC wristwise {

/// How much a line matters.
enum class LogLevel {
  info,     ///< good to know
  warning,  ///< should be looked at
};

/// How the caller watches and stops a run. Every member may be left empty. The callbacks are called
/// from the calling thread only.
struct Monitor {
  /// "sampling", "search", "refine" (or "refine seed 2 of 3"), "verify"; done of that, 0 to 1.
  std::function<void(const std::string& stage, double fraction)> progress;
  std::function<void(LogLevel level, const std::string& line)> log;  ///< one line, without its end
  const std::atomic<bool>* cancel = nullptr;  ///< set it to stop at the next chance

  /// Whether the caller has asked to stop.
  bool cancelled() const { return cancel != nullptr && cancel->load(std::memory_order_relaxed); }
  /// Calls `progress` where there is one.
  void report(const std::string& stage, double fraction) const {
    if (progress) progress(stage, fraction);
  }
  /// Calls `log` where there is one.
  void write(LogLevel level, const std::string& line) const {
    if (log) log(level, line);
  }
};

}  // namespace wristwise
