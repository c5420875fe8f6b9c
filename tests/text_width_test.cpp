#include "picture/text_width.hpp"

#include <gtest/gtest.h>

namespace wristwise {
namespace {

TEST(FittedText, StaysAsItIsWhereItFits) {
  EXPECT_EQ(fitted("joint_a1", 12, 100), "joint_a1");
  EXPECT_EQ(fitted("", 12, 0), "");
}

TEST(FittedText, EndsWithAnEllipsisAndIsNoWider) {
  const std::string name = "a_very_long_name_of_a_joint";
  for (const double width : {20.0, 60.0, 150.0}) {
    const std::string text = fitted(name, 12, width);
    EXPECT_LE(text_width(text, 12), width);
    EXPECT_EQ(text.substr(text.size() - 3), "\u2026");
    EXPECT_EQ(text.substr(0, text.size() - 3), name.substr(0, text.size() - 3));
  }
}

TEST(FittedText, CutsBetweenCharactersNotBytes) {
  const std::string text = fitted("\u00e4\u00f6\u00fc\u00e4\u00f6\u00fc\u00e4\u00f6\u00fc", 10, 30);
  EXPECT_EQ(text, "\u00e4\u00f6\u00fc\u00e4\u2026");
  EXPECT_EQ(text_width("\u00e4\u00f6", 10), text_width("ao", 10));
}

}  // namespace
}  // namespace wristwise
