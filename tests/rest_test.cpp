#include "smoothing/rest.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "recording.hpp"

namespace wristwise {
namespace {

/// Stands until `begin`, goes at 0.1 m/s and 0.2 rad/s, stands from `end` on.
std::vector<Pose> halt_go_halt(const std::vector<double>& times, double begin, double end) {
  std::vector<Pose> poses;
  for (const double t : times) {
    const double s = std::clamp(t, begin, end) - begin;
    poses.push_back(Eigen::Translation3d(0.1 * s, 0, 0) *
                    Eigen::AngleAxisd(0.2 * s, Eigen::Vector3d::UnitZ()));
  }
  return poses;
}

TEST(Rest, LastsAsLongAsAskedAtEitherEnd) {
  const auto times = test::recording_times(301, 0.01);
  const auto poses = halt_go_halt(times, 0.5, 2.2);
  EXPECT_TRUE(rests_at_start(times, poses, 0.49, 1e-6, 1e-6));
  EXPECT_FALSE(rests_at_start(times, poses, 0.52, 1e-6, 1e-6));
  EXPECT_TRUE(rests_at_end(times, poses, 0.79, 1e-6, 1e-6));
  EXPECT_FALSE(rests_at_end(times, poses, 0.82, 1e-6, 1e-6));
}

TEST(Rest, TurningOnTheSpotIsNone) {
  const auto times = test::recording_times(301, 0.01);
  const auto poses = halt_go_halt(times, 0, 3);
  EXPECT_TRUE(rests_at_start(times, poses, 0.095, 1, 0.021));
  EXPECT_FALSE(rests_at_start(times, poses, 0.095, 1, 0.019));
  EXPECT_FALSE(rests_at_end(times, poses, 0.095, 0.0099, 1));
  EXPECT_TRUE(rests_at_end(times, poses, 0.095, 0.0101, 1));
}

TEST(Rest, AtOnePointOnlyIsNone) {
  const std::vector<double> times = {0, 1, 2};
  const auto poses = halt_go_halt(times, 0, 2);
  EXPECT_FALSE(rests_at_start(times, poses, 0.1, 1e-3, 1e-3));
  EXPECT_FALSE(rests_at_end(times, poses, 0.1, 1e-3, 1e-3));
}

TEST(Rest, ThatNeverEnds) {
  const std::vector<double> times = {0, 1};
  const std::vector<Pose> poses(2, Pose::Identity());
  EXPECT_TRUE(rests_at_start(times, poses, 100, 0, 0));
  EXPECT_TRUE(rests_at_end(times, poses, 100, 0, 0));
}

}  // namespace
}  // namespace wristwise
