#pragma once

#include <filesystem>
#include <string>

namespace wristwise::app {

/// Checks that an argument is a file.
/// @param what such as "a problem file"
/// @param extension of such files, with its dot
/// @throws InvalidInput that names the nearest one beside it, or one in the folder that was given
void require_file(const std::filesystem::path& file, const std::string& what,
                  const std::string& extension);

}  // namespace wristwise::app
