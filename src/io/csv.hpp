#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace wristwise {

/// A table of comma-separated values with a header. Blank lines and lines that start with # are
/// left out; cells are trimmed.
class CsvTable {
 public:
  /// @throws InvalidInput with file and line: missing, no header, a row of another width.
  explicit CsvTable(const std::filesystem::path& file) : CsvTable(file, {}) {}
  /// A file whose columns have these names; empty: its first line says them.
  CsvTable(const std::filesystem::path& file, std::vector<std::string> header);

  const std::vector<std::string>& header() const { return header_; }
  std::size_t rows() const { return rows_.size(); }

  /// @throws InvalidInput where the header names it twice.
  std::optional<std::size_t> find_column(const std::string& name) const;
  /// @throws InvalidInput where there is none, naming the nearest.
  std::size_t column(const std::string& name) const;

  /// @throws InvalidInput where the cell is no finite number.
  double number(std::size_t row, std::size_t column) const;

  /// "file:line"
  std::string where(std::size_t row) const;
  std::string where() const { return file_; }

 private:
  struct Row {
    int line;
    std::vector<std::string> cells;
  };
  std::string file_;
  std::vector<std::string> header_;
  int header_line_ = 0;
  std::vector<Row> rows_;
};

}  // namespace wristwise
