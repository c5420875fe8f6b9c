#pragma once

namespace wristwise::app {

enum ExitCode : int {
  kSolved = 0,
  kNotSolved = 1,
  kInvalidInput = 2,
  kInternalError = 3,
  kInterrupted = 130,
};

}  // namespace wristwise::app
