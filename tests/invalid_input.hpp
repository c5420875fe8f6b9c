#pragma once

#include <gtest/gtest.h>

#include <string>

#include "wristwise/error.hpp"

namespace wristwise::test {

/// What the InvalidInput that `call` throws says; fails the test where it throws none.
template <typename Call>
std::string invalid_input(const Call& call) {
  try {
    call();
  } catch (const InvalidInput& error) {
    return error.what();
  }
  ADD_FAILURE() << "no InvalidInput";
  return {};
}

inline bool says(const std::string& message, const std::string& part) {
  return message.find(part) != std::string::npos;
}

}  // namespace wristwise::test
