#include "io/csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "io/quantity.hpp"
#include "io/text_file.hpp"
#include "similar_names.hpp"
#include "wristwise/error.hpp"

namespace wristwise {

namespace {

std::string trim(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> cells;
  std::size_t start = 0;
  while (true) {
    const std::size_t comma = line.find(',', start);
    cells.push_back(trim(line.substr(start, comma - start)));
    if (comma == std::string::npos) return cells;
    start = comma + 1;
  }
}

}  // namespace

CsvTable::CsvTable(const std::filesystem::path& file, std::vector<std::string> header)
    : file_(file.string()), header_(std::move(header)), header_line_(1) {
  const bool named = !header_.empty();
  std::istringstream text(read_text(file));
  std::string line;
  for (int number = 1; std::getline(text, line); ++number) {
    line = trim(line);
    if (line.empty() || line[0] == '#') continue;
    std::vector<std::string> cells = split(line);
    if (header_.empty()) {
      header_ = std::move(cells);
      header_line_ = number;
      continue;
    }
    if (cells.size() != header_.size())
      throw InvalidInput(fmt::format("{}:{}", file_, number), fmt::format("{} cells", cells.size()),
                         named ? fmt::format("{}, one for each of `columns`", header_.size())
                               : fmt::format("{} as in the header", header_.size()));
    rows_.push_back({number, std::move(cells)});
  }
  if (header_.empty()) throw InvalidInput(file_, "empty", "a header and rows");
}

std::optional<std::size_t> CsvTable::find_column(const std::string& name) const {
  const auto found = std::find(header_.begin(), header_.end(), name);
  if (found == header_.end()) return std::nullopt;
  if (std::find(found + 1, header_.end(), name) != header_.end())
    throw InvalidInput(fmt::format("{}:{}", file_, header_line_),
                       fmt::format("two columns '{}'", name), "one");
  return static_cast<std::size_t>(found - header_.begin());
}

std::size_t CsvTable::column(const std::string& name) const {
  if (const auto found = find_column(name)) return *found;
  throw InvalidInput(
      fmt::format("{}:{}", file_, header_line_), fmt::format("no column '{}'", name),
      fmt::format("it in the header; the nearest there is {}", similar_names(name, header_, 1)));
}

double CsvTable::number(std::size_t row, std::size_t column) const {
  const std::string& cell = rows_[row].cells[column];
  const std::optional<double> value = parse_number(cell);
  if (!value || !std::isfinite(*value))
    throw InvalidInput(where(row), fmt::format("'{}' in column '{}'", cell, header_[column]),
                       "a finite number");
  return *value;
}

std::string CsvTable::where(std::size_t row) const {
  return fmt::format("{}:{}", file_, rows_[row].line);
}

}  // namespace wristwise
