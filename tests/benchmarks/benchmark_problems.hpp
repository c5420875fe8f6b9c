#pragma once

#include <malloc.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <functional>
#include <string>

#include "wristwise/wristwise.hpp"

namespace wristwise::benchmarks {

inline Problem shipped(const std::string& name) {
  return load_problem(std::string(WRISTWISE_SOURCE_DIR) + "/problems/" + name + ".yaml");
}

inline PlanOptions threads(int count) {
  PlanOptions options;
  options.threads = count;
  return options;
}

/// MB, of a process of its own that does this.
inline double peak_memory(const std::function<void()>& work) {
  malloc_trim(0);  // what this process has freed must not serve the other
  const pid_t child = fork();
  if (child == 0) {
    work();
    _exit(0);
  }
  int status = 0;
  rusage usage{};
  wait4(child, &status, 0, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

}  // namespace wristwise::benchmarks
