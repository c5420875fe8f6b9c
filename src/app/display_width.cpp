#include "app/display_width.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace wristwise::app {

namespace {

struct Range {
  char32_t first, last;
};

// Unicode 15, general categories Mn, Me and Cf as far as Latin, Greek and Cyrillic text uses them.
constexpr std::array<Range, 7> kNoColumn = {{{0x300, 0x36F},
                                             {0x483, 0x489},
                                             {0x1AB0, 0x1ACE},
                                             {0x1DC0, 0x1DFF},
                                             {0x200B, 0x200F},
                                             {0x20D0, 0x20F0},
                                             {0xFE00, 0xFE0F}}};
// Unicode 15, East Asian width W and F.
constexpr std::array<Range, 12> kTwoColumns = {{{0x1100, 0x115F},
                                                {0x2E80, 0x303E},
                                                {0x3041, 0x33FF},
                                                {0x3400, 0x4DBF},
                                                {0x4E00, 0xA4C6},
                                                {0xAC00, 0xD7A3},
                                                {0xF900, 0xFAFF},
                                                {0xFE30, 0xFE6B},
                                                {0xFF01, 0xFF60},
                                                {0xFFE0, 0xFFE6},
                                                {0x1F300, 0x1F64F},
                                                {0x20000, 0x3FFFD}}};

template <std::size_t N>
bool is_in(char32_t character, const std::array<Range, N>& ranges) {
  return std::any_of(ranges.begin(), ranges.end(), [&](const Range& range) {
    return character >= range.first && character <= range.last;
  });
}

/// Bytes of the escape sequence at the start of `text`; 0 where there is none.
std::size_t escape_length(std::string_view text) {
  if (text.size() < 2 || text[0] != '\033' || text[1] != '[') return 0;
  const std::size_t end = text.find_first_not_of("0123456789;", 2);
  return end == std::string_view::npos ? text.size() : end + 1;
}

std::size_t sequence_length(unsigned char lead) {
  if (lead < 0x80) return 1;
  if (lead >= 0xC2 && lead < 0xE0) return 2;
  if (lead >= 0xE0 && lead < 0xF0) return 3;
  if (lead >= 0xF0 && lead < 0xF5) return 4;
  return 0;
}

/// The character at the start of `text` and its bytes; a byte that is no UTF-8 stands for itself.
struct Character {
  char32_t code;
  std::size_t bytes;
};

Character first_character(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text[0]);
  const std::size_t bytes = sequence_length(lead);
  if (bytes < 2 || bytes > text.size()) return {lead, 1};
  char32_t code = lead & (0x7Fu >> bytes);
  for (std::size_t i = 1; i < bytes; ++i) {
    const auto next = static_cast<unsigned char>(text[i]);
    if ((next & 0xC0u) != 0x80u) return {lead, 1};
    code = code << 6u | (next & 0x3Fu);
  }
  return {code, bytes};
}

}  // namespace

int display_width(std::string_view text) {
  int width = 0;
  while (!text.empty()) {
    if (const std::size_t escape = escape_length(text); escape > 0) {
      text.remove_prefix(escape);
      continue;
    }
    const Character character = first_character(text);
    if (!is_in(character.code, kNoColumn)) width += is_in(character.code, kTwoColumns) ? 2 : 1;
    text.remove_prefix(character.bytes);
  }
  return width;
}

}  // namespace wristwise::app
