#include "io/text_file.hpp"

#include <unistd.h>

#include <fstream>
#include <iterator>
#include <stdexcept>

#include "wristwise/error.hpp"

namespace wristwise {

std::string read_text(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::exists(file, error)) throw InvalidInput(file.string(), "no such file");
  if (std::filesystem::is_directory(file, error))
    throw InvalidInput(file.string(), "is a folder", "a file");
  std::ifstream stream(file, std::ios::binary);
  std::string text((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
  if (!stream && !stream.eof()) throw InvalidInput(file.string(), "cannot be read");
  if (text.compare(0, 3, "\xEF\xBB\xBF") == 0) text.erase(0, 3);
  return text;
}

namespace {

void require_place_for(const std::filesystem::path& file) {
  std::error_code error;
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  if (!std::filesystem::is_directory(folder, error))
    throw InvalidInput(file.string(), "no such folder", "a folder that exists");
  if (std::filesystem::is_directory(file, error))
    throw InvalidInput(file.string(), "is a folder", "a file");
}

}  // namespace

void write_text(const std::filesystem::path& file, const std::string& text) {
  require_place_for(file);
  std::filesystem::path draft = file;
  draft += "." + std::to_string(getpid()) + ".tmp";
  {
    std::ofstream stream(draft, std::ios::binary | std::ios::trunc);
    stream.write(text.data(), static_cast<std::streamsize>(text.size()));
    stream.close();
    if (!stream) {
      std::error_code ignored;
      std::filesystem::remove(draft, ignored);
      throw std::runtime_error(file.string() + ": cannot be written");
    }
  }
  std::error_code error;
  std::filesystem::rename(draft, file, error);
  if (!error) return;
  std::error_code ignored;
  std::filesystem::remove(draft, ignored);
  throw std::runtime_error(file.string() + ": cannot be written: " + error.message());
}

}  // namespace wristwise
