#include "app/paint.hpp"

#include <cstdlib>

#include "app/terminal.hpp"

namespace wristwise::app {

namespace {

bool is_unwanted() {
  const char* no_color = std::getenv("NO_COLOR");
  return no_color != nullptr && *no_color != '\0';
}

}  // namespace

Paint::Paint(ColourChoice choice, int descriptor)
    : colours_(choice == ColourChoice::always ||
               (choice == ColourChoice::automatic && !is_unwanted() && is_terminal(descriptor))) {}

std::string Paint::in(const char* code, const std::string& text) const {
  return colours_ ? std::string("\033[") + code + "m" + text + "\033[0m" : text;
}

}  // namespace wristwise::app
