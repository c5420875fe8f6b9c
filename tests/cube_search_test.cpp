#include "placement/cube_search.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace wristwise {
namespace {

/// Two basins; the start is in the shallow one. Out of (0.1, 0.9)^2 a cliff.
double two_basins(const CubePoint& x) {
  const auto basin = [&x](double a, double b) { return std::hypot(x[0] - a, x[1] - b); };
  const double value = std::min(0.3 + basin(0.2, 0.2), basin(0.7, 0.8));
  const bool outside = x[0] < 0.1 || x[0] > 0.9 || x[1] < 0.1 || x[1] > 0.9;
  return outside ? 1000 + value : value;
}

TEST(CubeSearch, FindsTheDeeperBasinBeyondACliff) {
  for (std::uint32_t seed = 1; seed <= 5; ++seed) {
    const CubeMinimum coarse = search_globally(two_basins, {0.2, 0.2}, seed, 300);
    EXPECT_LT(coarse.value, 0.3) << seed;
    const CubeMinimum fine = search_locally(two_basins, coarse, 200);
    EXPECT_LE(fine.value, coarse.value);
    EXPECT_NEAR(fine.point[0], 0.7, 2e-3);
    EXPECT_NEAR(fine.point[1], 0.8, 2e-3);
    EXPECT_EQ(fine.value, two_basins(fine.point));
  }
}

TEST(CubeSearch, StaysInTheCubeAndWithinItsEvaluations) {
  int calls = 0;
  const CubeFunction slope = [&calls](const CubePoint& x) {
    ++calls;
    for (const double value : x) {
      EXPECT_GE(value, 0);
      EXPECT_LE(value, 1);
    }
    return x[0] + x[1] + x[2];
  };
  CubeMinimum best = search_globally(slope, {0.5, 0.5, 0.5}, 1, 60);
  EXPECT_LE(calls, 60);
  calls = 0;
  best = search_locally(slope, best, 200);
  EXPECT_LE(calls, 200);
  EXPECT_NEAR(best.value, 0, 1e-3);  // at the corner
}

TEST(CubeSearch, DependsOnTheSeedAlone) {
  const auto run = [](std::uint32_t seed) {
    return search_globally(two_basins, {0.5, 0.5}, seed, 100).point;
  };
  EXPECT_EQ(run(7), run(7));
  EXPECT_NE(run(7), run(8));
}

TEST(CubeSearch, OneEvaluationIsTheStart) {
  const CubePoint start = {0.4, 0.3};
  EXPECT_EQ(search_globally(two_basins, start, 1, 1).point, start);
}

TEST(CubeSearch, AFlatFunctionGivesThePlaceThatWasKnown) {
  const auto flat = [](const CubePoint&) { return 5.0; };
  EXPECT_EQ(search_locally(flat, {{0.25}, 5}, 50).point, CubePoint{0.25});
}

TEST(CubeSearch, WhatTheFunctionThrowsArrives) {
  struct Stop {};
  int calls = 0;
  const CubeFunction stops = [&calls](const CubePoint& x) {
    if (++calls == 10) throw Stop{};
    return x[0];
  };
  EXPECT_THROW(search_globally(stops, {0.5}, 1, 100), Stop);
  EXPECT_EQ(calls, 10);
  calls = 0;
  EXPECT_THROW(search_locally(stops, {{0.5}, 0.5}, 100), Stop);
  const CubeFunction fails = [](const CubePoint&) -> double { throw std::runtime_error("broken"); };
  EXPECT_THROW(search_globally(fails, {0.5}, 1, 100), std::runtime_error);
}

}  // namespace
}  // namespace wristwise
