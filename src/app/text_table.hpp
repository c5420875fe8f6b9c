#pragma once

#include <string>
#include <vector>

namespace wristwise::app {

using TableRow = std::vector<std::string>;

/// Columns of equal width, the first aligned to the left, the others to the right.
std::string aligned(const std::vector<TableRow>& rows, int indent = 2);

/// A number for people: four significant digits.
std::string short_number(double value);

}  // namespace wristwise::app
