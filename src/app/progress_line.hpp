#pragma once

#include <string>

namespace wristwise::app {

/// What is known of a run, at a moment.
struct Progress {
  std::string stage;
  bool even = true;          ///< the share grows evenly in time, so that it says what is left
  double fraction = 0;       ///< of the stage, 0 to 1; 0: nothing can be said
  double elapsed = 0;        ///< s, since the run started
  double stage_elapsed = 0;  ///< s
};

/// One line for people of at most `width` columns: stage, bar, share, time. The time that is left
/// of an even stage is there once it can be told: after 2 s and a tenth of the way. What has no
/// room is left out: what is left, then the bar, then the time.
std::string progress_line(const Progress& progress, int width);

}  // namespace wristwise::app
