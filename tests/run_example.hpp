#pragma once

#include <string>
#include <vector>

#include "run_program.hpp"

namespace wristwise::test {

/// A file of the repository.
inline std::string shipped(const std::string& file) {
  return std::string(WRISTWISE_SOURCE_DIR) + "/" + file;
}

/// Runs an example of docs/examples in a folder.
inline ProgramRun run_example(const std::string& example, const TemporaryFolder& folder,
                              const std::vector<std::string>& arguments) {
  return run_executable(std::string(WRISTWISE_EXAMPLES) + "/" + example, folder.path(), arguments);
}

}  // namespace wristwise::test
