#pragma once

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace wristwise::test {

/// A CSV file of numbers under a header; reads as a script would, without the library.
class CsvColumns {
 public:
  explicit CsvColumns(const std::filesystem::path& file) {
    std::ifstream stream(file);
    EXPECT_TRUE(stream) << file;
    std::string line;
    std::getline(stream, line);
    const std::vector<std::string> names = cells(line);
    while (std::getline(stream, line)) {
      const std::vector<std::string> row = cells(line);
      EXPECT_EQ(row.size(), names.size()) << file;
      for (std::size_t i = 0; i < names.size() && i < row.size(); ++i)
        columns_[names[i]].push_back(std::stod(row[i]));
    }
  }

  std::vector<double> column(const std::string& name) const {
    const auto found = columns_.find(name);
    EXPECT_NE(found, columns_.end()) << name;
    return found == columns_.end() ? std::vector<double>() : found->second;
  }

  /// The values of several columns, row by row.
  std::vector<Eigen::VectorXd> rows(const std::vector<std::string>& names) const {
    std::vector<Eigen::VectorXd> result;
    for (std::size_t j = 0; j < names.size(); ++j) {
      const std::vector<double> values = column(names[j]);
      if (j == 0)
        result.assign(values.size(), Eigen::VectorXd(static_cast<Eigen::Index>(names.size())));
      for (std::size_t i = 0; i < values.size(); ++i)
        result[i][static_cast<Eigen::Index>(j)] = values[i];
    }
    return result;
  }

 private:
  static std::vector<std::string> cells(const std::string& line) {
    std::vector<std::string> result;
    std::istringstream stream(line);
    for (std::string cell; std::getline(stream, cell, ',');) result.push_back(cell);
    return result;
  }

  std::map<std::string, std::vector<double>> columns_;
};

}  // namespace wristwise::test
