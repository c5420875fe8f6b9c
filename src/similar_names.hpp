#pragma once

#include <string>
#include <vector>

namespace wristwise {

/// The candidates nearest to a misspelt name by edit distance, quoted and separated by commas.
std::string similar_names(const std::string& name, const std::vector<std::string>& candidates,
                          std::size_t count = 3);

}  // namespace wristwise
