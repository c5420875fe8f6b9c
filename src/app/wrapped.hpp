#pragma once

#include <string>

namespace wristwise::app {

/// Breaks lines that are wider than a terminal between words. The rest of a line starts below its
/// last column where it is a table's (two or more spaces before it), else `hanging` columns further
/// in.
std::string wrapped(const std::string& text, int width, int hanging = 4);

}  // namespace wristwise::app
