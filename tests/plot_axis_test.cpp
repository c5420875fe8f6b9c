#include "picture/plot_axis.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace wristwise {
namespace {

TEST(PlotAxis, PixelsAreLinearInEitherDirection) {
  const PlotAxis right{-1, 3, 100, 500}, up{0, 2, 400, 0};
  EXPECT_EQ(right.pixel(-1), 100);
  EXPECT_EQ(right.pixel(1), 300);
  EXPECT_EQ(up.pixel(0), 400);
  EXPECT_EQ(up.pixel(1.5), 100);
}

TEST(PlotAxis, TicksAreRoundValuesInside) {
  EXPECT_EQ(ticks({0, 1, 0, 1}, 5), (std::vector<double>{0, 0.2, 0.4, 0.6000000000000001, 0.8, 1}));
  std::mt19937 random(2);
  std::uniform_real_distribution<double> any(-1, 1);
  for (int k = 0; k < 2000; ++k) {
    const double from = any(random) * std::pow(10, 4 * any(random));
    const double width = (1.01 + any(random)) * std::pow(10, 4 * any(random));
    const auto values = ticks({from, from + width, 0, 1});
    ASSERT_GE(values.size(), 1U);
    EXPECT_LE(values.size(), 8U);
    const double noise = 1e-6 * width;
    EXPECT_GE(values.front(), from - noise);
    EXPECT_LE(values.back(), from + width + noise);
    if (values.size() < 2) continue;
    const double step = values[1] - values[0];
    const double digit = step / std::pow(10, std::floor(std::log10(step) + 1e-4));
    EXPECT_LT(std::min({std::abs(digit - 1), std::abs(digit - 2), std::abs(digit - 5)}), 1e-4);
    for (const double value : values)
      EXPECT_NEAR(value / step, std::round(value / step), 1e-6 * (1 + std::abs(value / step)));
  }
}

TEST(PlotAxis, AnAxisWithoutWidthHasOneTick) {
  EXPECT_EQ(ticks({2, 2, 0, 1}), std::vector<double>{2});
  EXPECT_EQ(ticks({2, 1, 0, 1}).size(), 1U);
}

TEST(PlotAxis, TextHasNoNoise) {
  EXPECT_EQ(tick_text(0.1 + 0.2), "0.3");
  EXPECT_EQ(tick_text(-0.0), "0");
  EXPECT_EQ(tick_text(-1e-3), "-0.001");
}

}  // namespace
}  // namespace wristwise
