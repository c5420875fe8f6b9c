#include "app/interrupt.hpp"

#include <unistd.h>

#include <csignal>

namespace wristwise::app {

namespace {

std::atomic<bool> stop{false};
std::atomic<bool> line_on_screen{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may not lock");

extern "C" void stop_on_signal(int number) {
  if (!stop.exchange(true)) return;
  if (line_on_screen.load()) {
    const ssize_t ignored = write(STDERR_FILENO, "\r\033[K", 4);
    static_cast<void>(ignored);
  }
  signal(number, SIG_DFL);
  raise(number);
}

}  // namespace

void catch_interrupts() {
  struct sigaction action {};
  action.sa_handler = stop_on_signal;
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

const std::atomic<bool>& interrupted() { return stop; }

void clear_line_when_ended(bool shown) { line_on_screen.store(shown); }

}  // namespace wristwise::app
