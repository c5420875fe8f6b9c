#pragma once

#include "wristwise/plan.hpp"

namespace wristwise::app {

enum ExitCode : int {
  kSolved = 0,
  kNotSolved = 1,
  kInvalidInput = 2,
  kInternalError = 3,
  kInterrupted = 130,
};

constexpr ExitCode exit_code_of(Status status) {
  if (status == Status::solved) return kSolved;
  return status == Status::interrupted ? kInterrupted : kNotSolved;
}

}  // namespace wristwise::app
