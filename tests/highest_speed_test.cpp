#include "timing/highest_speed.hpp"

#include <gtest/gtest.h>

namespace wristwise {
namespace {

class LeastFactor : public testing::TestWithParam<double> {};

TEST_P(LeastFactor, IsFoundTo2Percent) {
  const double least = GetParam();
  for (const double guess : {1.05, 1.5, 4.0, 30.0}) {
    int tried = 0;
    const auto works = [&](double factor) {
      ++tried;
      EXPECT_GT(factor, 1);
      return factor >= least;
    };
    const auto found = least_working_factor(works, guess);
    if (least > guess * 5.9) {  // eight steps of 1.25
      EXPECT_FALSE(found);
      continue;
    }
    ASSERT_TRUE(found);
    EXPECT_GE(*found, least);
    EXPECT_LE(*found, 1.0201 * least);
    EXPECT_LE(tried, 30);
  }
}

INSTANTIATE_TEST_SUITE_P(Factors, LeastFactor, testing::Values(1.001, 1.3, 3.7, 20.0));

TEST(LeastFactor, NothingWorks) {
  EXPECT_FALSE(least_working_factor([](double) { return false; }, 2));
}

TEST(LeastFactor, IsOneThatWasTried) {
  double last = 0;
  const auto found = least_working_factor(
      [&](double factor) {
        if (factor >= 2.345) last = factor;
        return factor >= 2.345;
      },
      3);
  ASSERT_TRUE(found);
  EXPECT_EQ(*found, last);
}

}  // namespace
}  // namespace wristwise
