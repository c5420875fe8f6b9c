#include "refine/seam_features.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "seam_samples.hpp"

namespace wristwise {
namespace {

using test::describe;
using test::line;
using test::turned_at;

/// An L of 50 mm and 50 mm at 10 mm/s, its corner run through at a fifth of that.
Task slow_corner(double between) {
  SeamDescription description = describe({line(turned_at(0, 0, 0), turned_at(0.05, 0, 0)),
                                          line(turned_at(0.05, 0, 0), turned_at(0.05, 0.05, 0))});
  description.corners.kind = CornerOptions::Kind::slow;
  Task task = build_task(test::sliding_robot(), description);
  task.between_position = between;
  return task;
}

double finest_of(const std::vector<SeamFeature>& features) {
  double finest = 1e9;
  for (const SeamFeature& feature : features) finest = std::min(finest, feature.finest);
  return finest;
}

/// The corner's jump in velocity is sqrt(2) 2 mm/s; a fourth of the time that 0.05 mm take at that.
TEST(SeamFeatures, ASlowCornerHasSpansByItsTolerance) {
  const Task task = slow_corner(5e-5);
  const auto features = seam_features(task, 0.1);
  EXPECT_NEAR(finest_of(features), 5e-5 / (std::sqrt(2) * 2e-3) / 4, 1e-6);
}

TEST(SeamFeatures, ACornerWithoutToleranceHasSpansOfALengthStill) {
  for (const double between : {0.0, 1e-300, 1e-12}) {
    const auto features = seam_features(slow_corner(between), 0.1);
    ASSERT_FALSE(features.empty());
    EXPECT_GE(finest_of(features), 1e-5);
  }
}

/// 10 mm/s into a circle of radius 10 mm: the acceleration jumps by 10 mm/s^2 at its ends.
TEST(SeamFeatures, TheEndsOfAnArcHaveShortSpans) {
  SeamDescription description =
      describe({line(turned_at(0, 0, 0), turned_at(0.05, 0, 0)),
                {ArcSegment{turned_at(0.05, 0, 0), Eigen::Vector3d(0.05, 0.01, 0),
                            Eigen::Vector3d::UnitZ(), 1.5},
                 {},
                 "arc"}});
  const Task task = build_task(test::sliding_robot(), description);
  const auto features = seam_features(task, 0.5);
  ASSERT_EQ(features.size(), 1U);
  EXPECT_NEAR(features.front().time, 5, 1e-9);
  EXPECT_NEAR(features.front().finest, 0.1, 1e-3);  // 0.1 s squared times the jump is 0.1 mm
  EXPECT_TRUE(seam_features(task, 0.1).empty());    // too short to show
}

TEST(SeamFeatures, AStraightSeamHasNone) {
  const Task task = build_task(test::sliding_robot(),
                               describe({line(turned_at(0, 0, 0), turned_at(0.05, 0, 0))}));
  EXPECT_TRUE(seam_features(task, 0.1).empty());
}

/// As a recorded path draws it: a second difference of a line 10 us long is all round-off.
TEST(SeamFeatures, ManyShortLinesHaveNone) {
  std::vector<SeamPiece> pieces(1000);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const auto at = [](std::size_t k) { return 1e-6 * static_cast<double>(k); };
    pieces[i].from = turned_at(1 + at(i), 0.5, 0.2);
    pieces[i].to = turned_at(1 + at(i + 1), 0.5, 0.2);
    pieces[i].start_time = 10 * at(i);
    pieces[i].end_time = 10 * at(i + 1);
  }
  Task task;
  task.waypoints.resize(2);
  task.waypoints.back().time = pieces.back().end_time;
  task.seam = Seam(std::move(pieces));
  EXPECT_TRUE(seam_features(task, 0.1).empty());
}

}  // namespace
}  // namespace wristwise
