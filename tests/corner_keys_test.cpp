#include <gtest/gtest.h>

#include <array>

#include "gantry_urdf.hpp"
#include "invalid_input.hpp"
#include "temporary_folder.hpp"
#include "wristwise/problem.hpp"

namespace wristwise {
namespace {

using test::invalid_input;
using test::says;
using test::TemporaryFolder;

constexpr double kDegree = 3.14159265358979323846 / 180;

/// An L of 0.5 m and 0.5 m, the frame turned by 60 deg at the corner; 0.1 m/s.
class CornerKeys : public testing::Test {
 protected:
  CornerKeys() { folder_.write("gantry.urdf", test::kGantryUrdf); }

  /// What is to be tested stands on line 8.
  Task task(const std::string& line, const std::string& angle = "60 deg") {
    return load_problem(
               folder_.write("test_problem.yaml",
                             "robot: {urdf: gantry.urdf}\nscene: {collision: off}\npath:\n"
                             "  speed: 0.1\n  spacing: 0.1\n  tolerance: {x: 1 mm}\n"
                             "  frame: {xyz: [0, 0, 1], rpy: [0, 0, 90 deg]}\n  " +
                                 line +
                                 "\n  segments:\n"
                                 "    - line: {from: {xyz: [0, 0, 0]}, to: {xyz: [0.5, 0, 0]}}\n"
                                 "    - line: {from: {xyz: [0.5, 0, 0], rpy: [0, 0, " +
                                 angle + "]}, to: {xyz: [0.5, 0.5, 0], rpy: [0, 0, " + angle +
                                 "]}}\n"))
        .task;
  }

  TemporaryFolder folder_;
};

TEST_F(CornerKeys, CornersAreKeptUnlessToldOtherwise) {
  for (const char* line : {"", "corners: keep"}) {
    const Task kept = task(line);
    EXPECT_FALSE(kept.seam.is_retimed());
    EXPECT_NEAR(kept.seam.end_time(), 10, 1e-12);
    EXPECT_FALSE(kept.rest_at_start || kept.rest_at_end);
    EXPECT_EQ(kept.speed_policy, SpeedPolicy::hold);
  }
}

TEST_F(CornerKeys, Stop) {
  EXPECT_NEAR(task("corners: stop").seam.end_time(), 10 + 0.5 + 15.0 / 8 * 2, 1e-12);
  EXPECT_NEAR(task("corners: {stop: 200 ms}").seam.end_time(), 10 + 0.2 + 15.0 / 8 * 2, 1e-12);
  EXPECT_NEAR(task("corners: {stop: 1, turn_rate: 60 deg/s}").seam.end_time(), 10 + 1 + 15.0 / 8,
              1e-12);
}

TEST_F(CornerKeys, Slow) {
  const auto slowest = [](const Task& task) {
    return task.seam.speed_ratio(task.seam.real_time(5));
  };
  EXPECT_NEAR(slowest(task("corners: slow", "0")), 0.2, 1e-12);
  const Task other = task("corners: {slow: 0.5, ramp: 2 s}", "0");
  EXPECT_NEAR(slowest(other), 0.5, 1e-12);
  EXPECT_NEAR(other.seam.end_time(), 10 + 2 * 0.5, 1e-12);
}

TEST_F(CornerKeys, Blend) {
  const Task blended = task("corners: {blend: 5 cm}");
  ASSERT_EQ(blended.seam.pieces().size(), 3U);
  EXPECT_EQ(blended.seam.pieces()[1].kind, SeamPiece::Kind::curve);
  EXPECT_NEAR(blended.seam.pieces()[0].length(), 0.45, 1e-12);
}

TEST_F(CornerKeys, RunInAndRunOut) {
  const Task straight = task("run_in: 10 mm\n  run_out: 20 mm");
  EXPECT_TRUE(straight.rest_at_start && straight.rest_at_end);
  EXPECT_NEAR(straight.seam.start_time(), -0.2, 1e-12);
  EXPECT_NEAR(straight.seam.end_time(), 10.4, 1e-12);
  const Task away = task(
      "run_in: {approach: [0, 0, -5 cm], duration: 2 s}\n  run_out: {retract: [0.3, 0, -0.4]}");
  EXPECT_NEAR(away.seam.start_time(), -2, 1e-12);
  EXPECT_NEAR(away.seam.end_time(), 10 + 2 * 0.5 / 0.1, 1e-12);
  EXPECT_NEAR(away.seam.frame_at(-2).translation().z(), 0.95, 1e-12);
  // In the frame of the last waypoint, which is turned by 60 deg in the part's.
  const Eigen::Vector3d retract =
      away.seam.frame_at(20).translation() - away.seam.frame_at(10).translation();
  EXPECT_NEAR(retract.x(), 0.3 * std::cos(150 * kDegree), 1e-12);
  EXPECT_NEAR(retract.y(), 0.3 * std::sin(150 * kDegree), 1e-12);
}

TEST_F(CornerKeys, SpeedPolicy) {
  EXPECT_EQ(task("speed_policy: slow").speed_policy, SpeedPolicy::slow);
  EXPECT_EQ(task("speed_policy: hold").speed_policy, SpeedPolicy::hold);
}

TEST_F(CornerKeys, MistakesAreNamed) {
  const std::vector<std::array<std::string, 3>> cases = {
      {"corners: round", ":8: path.corners", "{blend: distance}"},
      {"corners: blend", ":8: path.corners", "{blend: distance}"},
      {"corners: {halt: 1}", ":8: path.corners", "{blend: distance}"},
      {"corners: {stop: 0}", "path.corners.stop", "above zero"},
      {"corners: {stop: 1 mm}", "path.corners.stop", "a time"},
      {"corners: {stop: 1 s, ramp: 2}", "path.corners", "ramp"},
      {"corners: {stop: 1 s, turn_rate: 3 deg}", "turn_rate", "a rate of turn"},
      {"corners: {slow: 1}", "path.corners.slow", "between 0 and 1"},
      {"corners: {slow: 0}", "path.corners.slow", "above zero"},
      {"corners: {blend: 0}", "path.corners.blend", "above zero"},
      {"corners: {blend: .nan}", "path.corners.blend", "finite"},
      {"corners: {blend: 0.6}", "corner at the start of", "does not fit"},
      {"corners: slow", "corner at the start of", "60 deg"},
      {"run_in: 0", "path.run_in", "above zero"},
      {"run_in: {retract: [0, 0, 1]}", "path.run_in", "retract"},
      {"run_in: {duration: 1}", "path.run_in", "approach"},
      {"run_in: {approach: [0, 0, 0]}", "path.run_in", "get up to speed"},
      {"run_out: {retract: [0, 0, -0.1], duration: 0}", "path.run_out.duration", "above zero"},
      {"speed_policy: fast", "path.speed_policy", "hold or slow"}};
  for (const auto& [line, place, problem] : cases) {
    const std::string text = line;
    const std::string message = invalid_input([&] { task(text); });
    EXPECT_TRUE(says(message, place) && says(message, problem)) << line << ": " << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

}  // namespace
}  // namespace wristwise
