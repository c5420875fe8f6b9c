#include "refine/breakpoints.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>

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

TEST(Subdivided, CutsLongSpansOnly) {
  EXPECT_EQ(with_long_spans_cut({0, 1, 4, 5.4}, 1), (std::vector<double>{0, 1, 2, 3, 4, 5.4}));
  EXPECT_EQ(with_long_spans_cut({0, 1}, 10), (std::vector<double>{0, 1}));
}

TEST(Graded, IsFineAtTheCentresAndNoFinerElsewhere) {
  std::vector<double> even;
  for (int i = 0; i <= 20; ++i) even.push_back(i);
  EXPECT_EQ(graded(even, {}), even);
  const auto breakpoints = graded(even, {{7.3, 0.1}, {7.45, 0.1}, {15, 0.1}});
  EXPECT_EQ(breakpoints.front(), 0);
  EXPECT_EQ(breakpoints.back(), 20);
  for (const double centre : {7.3, 7.45, 15.0}) {
    const auto place = std::find(breakpoints.begin(), breakpoints.end(), centre);
    ASSERT_NE(place, breakpoints.end()) << centre;
    EXPECT_LE(*std::next(place) - centre, 0.16);
    EXPECT_LE(centre - *std::prev(place), 0.16);
  }
  for (std::size_t i = 0; i + 1 < breakpoints.size(); ++i) {
    const double width = breakpoints[i + 1] - breakpoints[i];
    EXPECT_GE(width, 0.0299);
    EXPECT_LE(width, 1.7);
    if (i == 0) continue;
    EXPECT_LE(width / (breakpoints[i] - breakpoints[i - 1]), 3.5) << breakpoints[i];
  }
  EXPECT_LT(breakpoints.size(), 60U);
}

TEST(SplitInHalves, SplitsWhereItIsAsked) {
  const std::vector<double> breakpoints = {0, 1, 2, 4};
  EXPECT_EQ(split_in_halves(breakpoints, {}, 0), breakpoints);
  EXPECT_EQ(split_in_halves(breakpoints, {0.3}, 0), (std::vector<double>{0, 0.5, 1, 2, 4}));
  // A breakpoint belongs to both of its spans.
  EXPECT_EQ(split_in_halves(breakpoints, {1.0}, 0), (std::vector<double>{0, 0.5, 1, 1.5, 2, 4}));
  EXPECT_EQ(split_in_halves(breakpoints, {0.3, 3}, 0.6), (std::vector<double>{0, 1, 2, 3, 4}));
}

TEST(SplitAtPlaces, TakesThePlaceNearestToTheMiddle) {
  const std::vector<double> breakpoints = {0, 1, 2, 4};
  EXPECT_EQ(split_at_places(breakpoints, {3}, {0, 2, 2.1, 2.7, 3.4, 4}),
            (std::vector<double>{0, 1, 2, 2.7, 4}));
  EXPECT_EQ(split_at_places(breakpoints, {0.5, 3}, {0, 1, 2, 3.9, 4}),
            (std::vector<double>{0, 1, 2, 3.9, 4}));
  EXPECT_EQ(split_at_places(breakpoints, {3}, {0, 1, 2, 4}), breakpoints);
}

}  // namespace
}  // namespace wristwise
