#include "app/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/display_width.hpp"

namespace wristwise::app {

namespace {

std::vector<int> column_widths(const std::vector<TableRow>& rows) {
  std::vector<int> widths;
  for (const TableRow& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t i = 0; i < row.size(); ++i)
      widths[i] = std::max(widths[i], display_width(row[i]));
  }
  return widths;
}

}  // namespace

std::string aligned(const std::vector<TableRow>& rows, int indent, Flush flush) {
  const std::vector<int> widths = column_widths(rows);
  std::string text;
  for (const TableRow& row : rows) {
    std::string line(static_cast<std::size_t>(indent), ' ');
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string padding(static_cast<std::size_t>(widths[i] - display_width(row[i])), ' ');
      if (i > 0) line += "  ";
      line += i == 0 || flush == Flush::left ? row[i] + padding : padding + row[i];
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

std::string short_number(double value) { return fmt::format("{:.4g}", value); }

}  // namespace wristwise::app
