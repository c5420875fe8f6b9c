#pragma once

#include <string>
#include <vector>

namespace wristwise::app {

using TableRow = std::vector<std::string>;

/// Where the columns after the first are flush: numbers right, text left.
enum class Flush { left, right };

/// Columns of equal width on a terminal, two apart, the first flush left.
std::string aligned(const std::vector<TableRow>& rows, int indent = 2, Flush flush = Flush::right);

/// A number for people: four significant digits.
std::string short_number(double value);

}  // namespace wristwise::app
