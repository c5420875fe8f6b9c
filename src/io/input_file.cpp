#include "io/input_file.hpp"

#include <fstream>
#include <iterator>
#include <set>

#include "io/sha256.hpp"
#include "wristwise/error.hpp"

namespace wristwise {

namespace {

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string bytes((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
  if (!stream && !stream.eof()) throw InvalidInput(file.string(), "cannot be read");
  return bytes;
}

}  // namespace

std::vector<InputFile> input_files(const std::vector<std::filesystem::path>& files) {
  std::vector<InputFile> inputs;
  std::set<std::filesystem::path> seen;
  for (const std::filesystem::path& file : files) {
    if (!seen.insert(std::filesystem::weakly_canonical(file)).second) continue;
    const std::string bytes = bytes_of(file);
    inputs.push_back({file.lexically_normal().string(), bytes.size(), sha256(bytes)});
  }
  return inputs;
}

}  // namespace wristwise
