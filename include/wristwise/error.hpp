#pragma once

#include <stdexcept>
#include <string>

#include "wristwise/visibility.hpp"

namespace WRISTWISE_PUBLIC wristwise {

/// The one exception for input that cannot be used: an unknown key, a missing file, NaN, inverted
/// bounds. `what()` is one line: "<where>: <problem>; expected <expected>".
class InvalidInput : public std::runtime_error {
 public:
  /// @param where file with key or line, or the name of the argument
  /// @param problem what is wrong
  /// @param expected what would be right; may be empty
  InvalidInput(const std::string& where, const std::string& problem,
               const std::string& expected = {})
      : std::runtime_error(where + ": " + problem +
                           (expected.empty() ? "" : "; expected " + expected)) {}
};

}  // namespace wristwise
