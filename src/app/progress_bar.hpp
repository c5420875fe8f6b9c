#pragma once

#include <string>

namespace wristwise::app {

/// A bar on stderr, where that is a terminal.
class ProgressBar {
 public:
  explicit ProgressBar(bool shown);
  ~ProgressBar() { clear(); }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void show(const std::string& stage, double fraction);
  void clear();

 private:
  bool shown_;
  std::string line_;  // on the screen
};

}  // namespace wristwise::app
