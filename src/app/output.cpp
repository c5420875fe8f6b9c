#include "app/output.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include "app/terminal.hpp"
#include "app/wrapped.hpp"

namespace wristwise::app {

void print(const std::string& text) {
  const bool is_seen = isatty(STDOUT_FILENO) == 1;
  fmt::print("{}", is_seen ? wrapped(text, terminal_width(STDOUT_FILENO)) : text);
}

}  // namespace wristwise::app
