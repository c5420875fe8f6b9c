#pragma once

#include "wristwise/monitor.hpp"

namespace wristwise {

/// Thrown inside the library when the caller cancels; `plan` turns it into Status::interrupted.
struct Cancelled {};

inline void throw_if_cancelled(const Monitor& monitor) {
  if (monitor.cancelled()) throw Cancelled{};
}

}  // namespace wristwise
