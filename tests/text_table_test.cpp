// Widths against the C library's wcwidth in a UTF-8 locale.

#include "app/text_table.hpp"

#include <gtest/gtest.h>
#include <wchar.h>

#include <clocale>
#include <random>
#include <sstream>

#include "app/display_width.hpp"
#include "app/wrapped.hpp"

namespace wristwise::app {
namespace {

std::string utf8(char32_t c) {
  const auto part = [c](unsigned shift) { return static_cast<char>(0x80u | (c >> shift & 0x3Fu)); };
  if (c < 0x80) return {static_cast<char>(c)};
  if (c < 0x800) return {static_cast<char>(0xC0u | c >> 6u), part(0)};
  if (c < 0x10000) return {static_cast<char>(0xE0u | c >> 12u), part(6), part(0)};
  return {static_cast<char>(0xF0u | c >> 18u), part(12), part(6), part(0)};
}

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

TEST(DisplayWidth, IsTheCLibrarys) {
  ASSERT_NE(std::setlocale(LC_CTYPE, "C.UTF-8"), nullptr);
  int compared = 0;
  // Latin, Greek, Cyrillic; arrows and mathematics; Chinese, Japanese, Korean.
  for (const auto& [first, last] : {std::pair{0x20, 0x7E},
                                    {0xA1, 0xAC},
                                    {0xAE, 0x377},
                                    {0x38E, 0x52F},
                                    {0x2190, 0x22FF},
                                    {0x3041, 0x3096},
                                    {0x4E00, 0x9FFF},
                                    {0xAC00, 0xD7A3},
                                    {0xFF01, 0xFF60}}) {
    for (int c = first; c <= last; ++c) {
      const int expected = wcwidth(static_cast<wchar_t>(c));
      if (expected < 0) continue;
      ++compared;
      ASSERT_EQ(display_width(utf8(static_cast<char32_t>(c))), expected) << std::hex << c;
    }
  }
  EXPECT_GT(compared, 30000);
}

TEST(DisplayWidth, EscapeSequencesHaveNone) {
  EXPECT_EQ(display_width("\033[1;31mFAILED\033[0m"), 6);
  EXPECT_EQ(display_width("\033["), 0);
}

TEST(DisplayWidth, BytesThatAreNoUtf8HaveOneEach) {
  EXPECT_EQ(display_width("\xFF\xC3"), 2);
  EXPECT_EQ(display_width("\xE4"
                          "b"),
            2);
}

TEST(TextTable, ColumnsEndAtTheSameColumn) {
  std::mt19937 random(3);
  const std::vector<std::string> cells = {
      "", "x", "Gelenk_ä", "-1.234e-05", "关节", "\033[1mb\033[0m", "日本", "-0", "0.1"};
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<TableRow> rows(1 + random() % 6);
    for (TableRow& row : rows)
      for (int i = 0; i < 4; ++i) row.push_back(cells[random() % cells.size()]);
    for (TableRow& row : rows) row.push_back("|");
    for (const Flush flush : {Flush::left, Flush::right}) {
      const auto lines = lines_of(aligned(rows, 2, flush));
      ASSERT_EQ(lines.size(), rows.size());
      for (const std::string& line : lines)
        EXPECT_EQ(display_width(line), display_width(lines.front())) << aligned(rows, 2, flush);
    }
  }
}

TEST(TextTable, NumbersAreFlushRightAndTextLeft) {
  EXPECT_EQ(aligned({{"a", "-1", "2"}, {"bcd", "10", "-300"}}, 0),
            "a    -1     2\n"
            "bcd  10  -300\n");
  EXPECT_EQ(aligned({{"a", "x"}, {"bcd", "yz"}}, 1, Flush::left), " a    x\n bcd  yz\n");
}

TEST(TextTable, RowsMayBeShort) { EXPECT_EQ(aligned({{"a", "b"}, {"c"}, {}}, 0), "a  b\nc\n\n"); }

TEST(Wrapped, KeepsEveryWordAndTheWidth) {
  std::mt19937 random(5);
  for (int trial = 0; trial < 300; ++trial) {
    std::string text = std::string(random() % 5, ' ');
    std::vector<std::string> words;
    for (int i = 0; i < 30; ++i) {
      words.push_back(std::string(1 + random() % 15, static_cast<char>('a' + i % 26)));
      text += words.back() + std::string(i == 3 ? 3 : 1, ' ');
    }
    const std::string result = wrapped(text, 60);
    for (const std::string& line : lines_of(result)) EXPECT_LE(display_width(line), 60) << result;
    std::istringstream stream(result);
    std::vector<std::string> kept;
    for (std::string word; stream >> word;) kept.push_back(word);
    EXPECT_EQ(kept, words);
  }
}

TEST(Wrapped, LinesThatFitStayAsTheyAre) {
  const std::string text = "a  b\n\n  long enough\n";
  EXPECT_EQ(wrapped(text, 13), text);
}

TEST(Wrapped, TheRestOfATablesCellStandsBelowIt) {
  EXPECT_EQ(wrapped("  key  one two three four five six\n", 30),
            "  key  one two three four five\n       six\n");
}

TEST(Wrapped, AWordThatIsTooLongStaysWhole) {
  EXPECT_EQ(wrapped(std::string(50, 'x') + " y\n", 30), std::string(50, 'x') + "\n    y\n");
}

}  // namespace
}  // namespace wristwise::app
