#pragma once

#include <cstddef>
#include <functional>

namespace wristwise {

/// One per core for 0 or less.
int thread_count(int requested);

/// Calls body(worker, index) for every index below `count`, from `threads` threads; worker is below
/// `threads`, and 0 is the calling thread. The first exception is rethrown when all have stopped.
void parallel_for(std::size_t count, int threads,
                  const std::function<void(int worker, std::size_t index)>& body);

}  // namespace wristwise
