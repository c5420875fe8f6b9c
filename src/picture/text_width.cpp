#include "picture/text_width.hpp"

#include <algorithm>

namespace wristwise {

namespace {

constexpr double kWidthOfCharacter = 0.56;  // of the font's size
const std::string kEllipsis = "\u2026";

bool starts_character(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U; }

std::size_t characters(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), starts_character));
}

}  // namespace

double text_width(const std::string& text, double size) {
  return kWidthOfCharacter * size * static_cast<double>(characters(text));
}

std::string fitted(const std::string& text, double size, double width) {
  if (text_width(text, size) <= width) return text;
  const double room = width / (kWidthOfCharacter * size) - 1;
  const auto most = static_cast<std::size_t>(std::max(0.0, room));
  std::string kept;
  std::size_t count = 0;
  for (const char byte : text) {
    if (starts_character(byte) && ++count > most) break;
    kept += byte;
  }
  return kept + kEllipsis;
}

}  // namespace wristwise
