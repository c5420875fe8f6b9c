#include "picture/line_thinning.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace wristwise {
namespace {

/// How far a point is above or below a line.
double off(const std::vector<SvgPoint>& line, const SvgPoint& point) {
  double least = std::abs(line.front().y - point.y) + std::abs(line.front().x - point.x);
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const SvgPoint &a = line[i], &b = line[i + 1];
    if (point.x < a.x || point.x > b.x) continue;
    const auto [low, high] = std::minmax(a.y, b.y);
    const double straight = b.x > a.x ? a.y + (point.x - a.x) / (b.x - a.x) * (b.y - a.y)
                                      : std::clamp(point.y, low, high);
    least = std::min(least, std::abs(straight - point.y));
  }
  return least;
}

std::vector<SvgPoint> smooth_line(int count, double width) {
  std::vector<SvgPoint> line;
  for (int i = 0; i < count; ++i) {
    const double x = width * i / (count - 1);
    line.push_back({x, 50 + 40 * std::sin(x / 23) + 5 * std::cos(x / 7)});
  }
  return line;
}

TEST(ThinnedLine, OfFewPointsPerPixelIsNowhereOffByMoreThanATenth) {
  const std::vector<SvgPoint> line = smooth_line(200, 250);
  const std::vector<SvgPoint> thin = thinned(line);
  EXPECT_LT(thin.size(), 120U);
  for (const SvgPoint& point : line) EXPECT_LE(off(thin, point), 0.1 + 1e-12) << point.x;
  EXPECT_EQ(thin.front().x, line.front().x);
  EXPECT_EQ(thin.back().x, line.back().x);
}

TEST(ThinnedLine, OfRandomPointsKeepsTheHeightsOfEveryColumn) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> height(0, 90);
  std::vector<SvgPoint> line;
  for (int i = 0; i < 100000; ++i) line.push_back({240.0 * i / 99999, height(random)});
  for (const double column : {1.0, 2.0}) {
    const std::vector<SvgPoint> thin = thinned(line, column);
    EXPECT_LE(static_cast<double>(thin.size()), 4 * (240 / column + 1));
    const auto number = [&](const SvgPoint& p) { return std::floor(p.x / column); };
    for (double c = 0; c < 240 / column; ++c) {
      double low = 1e9, high = -1e9, thin_low = 1e9, thin_high = -1e9;
      for (const SvgPoint& p : line)
        if (number(p) == c) low = std::min(low, p.y), high = std::max(high, p.y);
      for (const SvgPoint& p : thin)
        if (number(p) == c)
          thin_low = std::min(thin_low, p.y), thin_high = std::max(thin_high, p.y);
      ASSERT_NEAR(thin_low, low, 0.11) << c;
      ASSERT_NEAR(thin_high, high, 0.11) << c;
    }
  }
}

TEST(ThinnedLine, KeepsALonelyPeakAndAJump) {
  std::vector<SvgPoint> line;
  for (int i = 0; i <= 50000; ++i) line.push_back({i * 0.005, i == 31234 ? -7.0 : 40.0});
  line.push_back({250, 80});  // straight down
  const std::vector<SvgPoint> thin = thinned(line);
  EXPECT_LE(thin.size(), 8U);
  const auto [low, high] = std::minmax_element(
      thin.begin(), thin.end(), [](const SvgPoint& a, const SvgPoint& b) { return a.y < b.y; });
  EXPECT_EQ(low->y, -7);
  EXPECT_EQ(low->x, 31234 * 0.005);
  EXPECT_EQ(high->y, 80);
}

TEST(ThinnedLine, OfOneOrNoPointIsThat) {
  EXPECT_TRUE(thinned({}).empty());
  ASSERT_EQ(thinned({{3, 4}}).size(), 1U);
  EXPECT_EQ(thinned({{3, 4}})[0].y, 4);
  EXPECT_EQ(thinned({{3, 4}, {5, 4}, {7, 4}}).size(), 2U);
}

}  // namespace
}  // namespace wristwise
