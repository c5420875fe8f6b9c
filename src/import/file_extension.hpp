#pragma once

#include <filesystem>
#include <string>

namespace wristwise {

/// With its point, in small letters.
inline std::string file_extension(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return extension;
}

}  // namespace wristwise
