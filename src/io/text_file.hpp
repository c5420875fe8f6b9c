#pragma once

#include <filesystem>
#include <string>

namespace wristwise {

/// The whole file, without a UTF-8 byte order mark.
/// @throws InvalidInput naming the file where it is missing or cannot be read.
std::string read_text(const std::filesystem::path& file);

/// Writes beside the file and renames: it appears whole or not at all.
/// @throws std::runtime_error naming the file where that fails.
void write_text(const std::filesystem::path& file, const std::string& text);

}  // namespace wristwise
