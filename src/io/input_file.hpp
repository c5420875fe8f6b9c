#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace wristwise {

/// A file that a result was made from.
struct InputFile {
  std::string name;  ///< as it was given
  std::uintmax_t bytes = 0;
  std::string sha256;  ///< 64 hexadecimal digits
};

/// Of the content that the files have now; each file once, in the order given.
/// @throws InvalidInput for a file that cannot be read.
std::vector<InputFile> input_files(const std::vector<std::filesystem::path>& files);

}  // namespace wristwise
