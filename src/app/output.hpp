#pragma once

#include <string>

namespace wristwise::app {

/// Prints to stdout what a command found. On a terminal long lines are broken between words; in a
/// file or a pipe they stay whole.
void print(const std::string& text);

}  // namespace wristwise::app
