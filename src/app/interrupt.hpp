#pragma once

#include <atomic>

namespace wristwise::app {

/// From now on the first SIGINT or SIGTERM sets the flag; a second one ends the program.
void catch_interrupts();

/// Set when the user wants the program to stop.
const std::atomic<bool>& interrupted();

/// Whether there is a line on the screen that the second signal has to clear.
void clear_line_when_ended(bool shown);

}  // namespace wristwise::app
