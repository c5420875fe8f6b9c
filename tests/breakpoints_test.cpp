#include "refine/breakpoints.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
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

/// Straight for 20 s, a half circle in 4 s, straight for 20 s, at 10 mm/s.
Task half_circle_task(int waypoints) {
  constexpr double kPi = 3.14159265358979323846;
  Task task;
  for (int i = 0; i < waypoints; ++i) {
    Waypoint waypoint;
    waypoint.time = 44.0 * i / (waypoints - 1);
    const double t = waypoint.time, radius = 0.04 / kPi, angle = kPi * (t - 20) / 4;
    waypoint.frame.translation() =
        t < 20   ? Eigen::Vector3d(0.01 * (t - 20), 0, 0)
        : t < 24 ? Eigen::Vector3d(radius * std::sin(angle), radius * (1 - std::cos(angle)), 0)
                 : Eigen::Vector3d(-0.01 * (t - 24), 2 * radius, 0);
    task.waypoints.push_back(waypoint);
  }
  return task;
}

std::vector<double> times_of(const Task& task) {
  std::vector<double> times;
  for (const Waypoint& waypoint : task.waypoints) times.push_back(waypoint.time);
  return times;
}

double longest_span(const std::vector<double>& breakpoints, double from, double to) {
  double longest = 0;
  for (std::size_t i = 0; i + 1 < breakpoints.size(); ++i) {
    const bool overlaps = breakpoints[i] < to && breakpoints[i + 1] > from;
    if (overlaps) longest = std::max(longest, breakpoints[i + 1] - breakpoints[i]);
  }
  return longest;
}

double largest_ratio(const std::vector<double>& breakpoints) {
  double largest = 1;
  for (std::size_t i = 1; i + 1 < breakpoints.size(); ++i) {
    const double ratio =
        (breakpoints[i + 1] - breakpoints[i]) / (breakpoints[i] - breakpoints[i - 1]);
    largest = std::max({largest, ratio, 1 / ratio});
  }
  return largest;
}

TEST(ChooseBreakpoints, SpansAreShortWhereTheSeamTurnsAndLongElsewhere) {
  const Task task = half_circle_task(4401);
  const auto breakpoints = choose_breakpoints(times_of(task), 2, SeamTurning(task, 0.05), 0.25);
  EXPECT_EQ(breakpoints.front(), 0);
  EXPECT_EQ(breakpoints.back(), 44);
  EXPECT_LE(longest_span(breakpoints, 20.1, 23.9), 1.2 * 0.25 * 4 / 3.14159);
  EXPECT_GE(longest_span(breakpoints, 0, 10), 1.9);
  EXPECT_LE(largest_ratio(breakpoints), 1.75);
  EXPECT_LT(breakpoints.size(), 50U);
}

TEST(ChooseBreakpoints, WithoutTurnsAreThoseOfTheSpacing) {
  Task task = half_circle_task(441);
  task.waypoints.resize(200);
  const auto times = times_of(task);
  EXPECT_EQ(choose_breakpoints(times, 0.75, SeamTurning(task, 0.1), 0.25),
            choose_breakpoints(times, 0.75));
  EXPECT_EQ(choose_breakpoints({3}, 0.75, SeamTurning(task, 0.1), 0.25).size(), 1U);
}

TEST(EveryNth, KeepsTheEndsAndIsNested) {
  const SeamTurning none(Task{{}, {Waypoint{}}}, 1);
  const std::vector<double> fine = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
  EXPECT_EQ(every_nth(fine, 4, none, 0.5), (std::vector<double>{0, 5, 10}));
  EXPECT_EQ(every_nth(fine, 100, none, 0.5), (std::vector<double>{0, 10}));
  EXPECT_EQ(every_nth(fine, 1, none, 0.5), fine);
}

TEST(EveryNth, KeepsMoreWhereTheSeamTurns) {
  const Task task = half_circle_task(4401);
  const SeamTurning turning(task, 0.05);
  const auto fine = choose_breakpoints(times_of(task), 0.2, turning, 0.25);
  const auto coarse = every_nth(fine, 16, turning, 0.5);
  EXPECT_TRUE(std::includes(fine.begin(), fine.end(), coarse.begin(), coarse.end()));
  EXPECT_LE(longest_span(coarse, 20.2, 23.8), 0.5 * 4 / 3.14159 + 0.2);
  EXPECT_GE(longest_span(coarse, 0, 10), 2.5);
  EXPECT_LT(coarse.size(), fine.size() / 3);
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

TEST(MovedTo, TakesTheNearestTimesOnce) {
  const std::vector<double> times = {0, 1, 2, 3.5, 5};
  EXPECT_EQ(moved_to(times, {0, 0.2, 0.4, 0.9, 1.2, 3, 5}), (std::vector<double>{0, 1, 3.5, 5}));
  EXPECT_EQ(moved_to(times, times), times);
  EXPECT_EQ(moved_to(times, {-1, 6}), (std::vector<double>{0, 5}));
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
