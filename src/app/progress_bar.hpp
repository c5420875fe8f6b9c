#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

#include "app/progress_line.hpp"

namespace wristwise::app {

/// A line on stderr, where that is a terminal, that shows how far a run is. It is drawn from a
/// thread of its own, so that the time goes on whatever the run does; a run of less than a fifth of
/// a second shows none.
class ProgressBar {
 public:
  explicit ProgressBar(bool shown);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// Within a stage the share never goes back: a stage that starts again counts as another.
  void show(const std::string& stage, double fraction);

  /// Prints a line above the bar.
  void print_line(const std::string& line);

 private:
  using Clock = std::chrono::steady_clock;

  void draw_until_ended();
  void draw();
  void clear();

  std::mutex mutex_;
  std::condition_variable changed_;
  bool ended_ = false;
  std::string stage_ = "read";
  double fraction_ = 0;
  int reports_ = 0;  // of the stage
  Clock::time_point start_ = Clock::now(), stage_start_ = start_;
  std::string line_;  // on the screen
  std::thread drawer_;
};

}  // namespace wristwise::app
