#include "refine/breakpoints.hpp"

#include <gtest/gtest.h>

namespace wristwise {
namespace {

TEST(ChooseBreakpoints, KeepsTheEndsAndTheSpacing) {
  std::vector<double> times;
  for (int i = 0; i <= 100; ++i) times.push_back(0.1 * i);
  const auto breakpoints = choose_breakpoints(times, 0.75);
  EXPECT_EQ(breakpoints.front(), 0);
  EXPECT_EQ(breakpoints.back(), times.back());
  for (std::size_t i = 0; i + 1 < breakpoints.size(); ++i) {
    EXPECT_GE(breakpoints[i + 1] - breakpoints[i], 0.37);
    EXPECT_LE(breakpoints[i + 1] - breakpoints[i], 1.2);
  }
  EXPECT_EQ(choose_breakpoints(times, 0.01).size(), times.size());
  EXPECT_EQ(choose_breakpoints({0, 1}, 50).size(), 2U);
}

TEST(EveryNth, KeepsTheEndsAndIsNested) {
  const std::vector<double> fine = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
  EXPECT_EQ(every_nth(fine, 4), (std::vector<double>{0, 5, 10}));
  EXPECT_EQ(every_nth(fine, 100), (std::vector<double>{0, 10}));
  EXPECT_EQ(every_nth(fine, 1), fine);
}

TEST(WithSplitSpans, SplitsWhereItIsAsked) {
  const std::vector<double> breakpoints = {0, 1, 2, 4};
  EXPECT_EQ(with_split_spans(breakpoints, {}, {}, 0), breakpoints);
  EXPECT_EQ(with_split_spans(breakpoints, {0.3}, {}, 0), (std::vector<double>{0, 0.5, 1, 2, 4}));
  // A breakpoint belongs to both of its spans.
  EXPECT_EQ(with_split_spans(breakpoints, {1.0}, {}, 0),
            (std::vector<double>{0, 0.5, 1, 1.5, 2, 4}));
  // At a preferred time in the middle half; not shorter than asked.
  EXPECT_EQ(with_split_spans(breakpoints, {3}, {2.1, 2.7, 3.4, 3.9}, 0),
            (std::vector<double>{0, 1, 2, 2.7, 4}));
  EXPECT_EQ(with_split_spans(breakpoints, {3}, {2.1, 3.9}, 0),
            (std::vector<double>{0, 1, 2, 3, 4}));
  EXPECT_EQ(with_split_spans(breakpoints, {0.3, 3}, {}, 0.6),
            (std::vector<double>{0, 1, 2, 3, 4}));
}

}  // namespace
}  // namespace wristwise
