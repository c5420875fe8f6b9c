#include "app/output_folder.hpp"

#include <unistd.h>

#include "wristwise/error.hpp"

namespace wristwise::app {

std::filesystem::path output_folder(const std::filesystem::path& given,
                                    const std::filesystem::path& problem) {
  const std::filesystem::path folder =
      given.empty() ? std::filesystem::path("out") / problem.stem() : given;
  std::error_code error;
  std::filesystem::path existing = std::filesystem::absolute(folder);
  while (!std::filesystem::exists(existing, error) && existing.has_relative_path())
    existing = existing.parent_path();
  if (!std::filesystem::is_directory(existing, error))
    throw InvalidInput("--out " + folder.string(), existing.string() + " is a file", "a folder");
  if (access(existing.c_str(), W_OK) != 0)
    throw InvalidInput("--out " + folder.string(), existing.string() + " cannot be written to");
  return folder;
}

}  // namespace wristwise::app
