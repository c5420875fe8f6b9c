#include "app/progress_line.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace wristwise::app {
namespace {

TEST(ProgressLine, StageBarShareAndTime) {
  EXPECT_EQ(progress_line({"search", false, 0.5, 65, 1}, 66),
            "search     [####################--------------------]  50 %  1:05");
}

TEST(ProgressLine, SaysWhatIsLeftOnceThatCanBeTold) {
  const auto left = [](double fraction, double stage_elapsed) {
    const std::string line = progress_line({"sampling", true, fraction, 100, stage_elapsed}, 100);
    const std::size_t at = line.find("about ");
    return at == std::string::npos ? std::string() : line.substr(at);
  };
  EXPECT_EQ(left(0.25, 10), "about 0:30 left");
  EXPECT_EQ(left(0.5, 4000), "about 1:06:40 left");
  EXPECT_EQ(left(0.05, 10), "");  // too early in the stage
  EXPECT_EQ(left(0.5, 1.9), "");  // too early in time
  EXPECT_EQ(progress_line({"search", false, 0.5, 10, 10}, 100).find("left"), std::string::npos);
}

TEST(ProgressLine, WithoutAShareThereIsNoBar) {
  EXPECT_EQ(progress_line({"verify", true, 0, 7, 7}, 80), "verify      0:07");
}

TEST(ProgressLine, NeverWiderThanItsRoom) {
  for (int width = 0; width < 130; ++width) {
    for (const double fraction : {0.0, 0.001, 0.3, 0.999, 1.0}) {
      const std::string line = progress_line({"sampling", true, fraction, 3700, 3600}, width);
      EXPECT_LE(line.size(), static_cast<std::size_t>(width));
      if (width >= 60 && fraction > 0) {
        EXPECT_NE(line.find('['), std::string::npos) << width << line;
      }
    }
  }
}

TEST(ProgressLine, TheBarGrowsWithTheShare) {
  long before = -1;
  for (int percent = 1; percent <= 100; ++percent) {
    const std::string line = progress_line({"search", false, percent / 100.0, 0, 0}, 80);
    const long filled = std::count(line.begin(), line.end(), '#');
    EXPECT_GE(filled, before);
    before = filled;
  }
  EXPECT_EQ(before, 40);
}

}  // namespace
}  // namespace wristwise::app
