#pragma once

#include <atomic>

namespace wristwise::app {

/// From now on the first SIGINT or SIGTERM sets the flag; a second one ends the program.
void catch_interrupts();

/// Set when the user wants the program to stop.
const std::atomic<bool>& interrupted();

}  // namespace wristwise::app
