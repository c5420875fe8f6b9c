#include "app/wrapped.hpp"

#include <algorithm>
#include <sstream>

#include "app/display_width.hpp"

namespace wristwise::app {

namespace {

constexpr int kLeastText = 20;  // columns of text that a broken line must have

/// Columns before the rest of a broken line.
int hanging_indent(const std::string& line, int width, int hanging) {
  const std::size_t gap = line.rfind("  ");
  const std::size_t first = line.find_first_not_of(' ');
  const bool has_column = gap != std::string::npos && gap > first;
  const int column = has_column ? display_width(line.substr(0, gap + 2)) : 0;
  const int indent =
      has_column && column <= width - kLeastText ? column : static_cast<int>(first) + hanging;
  return std::min(indent, std::max(0, width - kLeastText));
}

std::string broken(const std::string& line, int width, int hanging) {
  const std::string indent(static_cast<std::size_t>(hanging_indent(line, width, hanging)), ' ');
  std::string text, current;
  std::size_t at = 0;
  while (at < line.size()) {
    const std::size_t word = line.find_first_not_of(' ', at);
    const std::size_t end = std::min(line.find(' ', word), line.size());
    const std::string spaced = line.substr(at, end - at);
    if (!current.empty() && display_width(current + spaced) > width &&
        current.find_first_not_of(' ') != std::string::npos) {
      text += current + "\n";
      current = indent + line.substr(word, end - word);
    } else {
      current += spaced;
    }
    at = end;
  }
  return text + current;
}

}  // namespace

std::string wrapped(const std::string& text, int width, int hanging) {
  std::istringstream lines(text);
  std::string line, result;
  while (std::getline(lines, line)) {
    line.erase(line.find_last_not_of(' ') + 1);
    result += (display_width(line) > width ? broken(line, width, hanging) : line) + "\n";
  }
  return result;
}

}  // namespace wristwise::app
