#include "picture/percent.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace wristwise {
namespace {

TEST(Percent, HasTwoDigitsBelowAHundredAndNoExponent) {
  EXPECT_EQ(percent(0), "0%");
  EXPECT_EQ(percent(0.0048), "0.48%");
  EXPECT_EQ(percent(0.5), "50%");
  EXPECT_EQ(percent(0.9949), "99%");
  EXPECT_EQ(percent(0.9951), "100%");
  EXPECT_EQ(percent(1), "100%");
  EXPECT_EQ(percent(37.2), "3720%");
}

TEST(Percent, OfNextToNothingOrNoNumberSaysSo) {
  EXPECT_EQ(percent(1e-9), "<0.01%");
  EXPECT_EQ(percent(std::nan("")), "-");
  EXPECT_EQ(percent(INFINITY), "-");
}

}  // namespace
}  // namespace wristwise
