#include "wristwise/seam.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "invalid_input.hpp"
#include "seam_samples.hpp"
#include "wristwise/robot.hpp"
#include "wristwise/seam_description.hpp"

namespace wristwise {
namespace {

using test::at;
using test::invalid_input;
using test::line;
using test::says;

constexpr double kPi = 3.14159265358979323846;

SeamDescription describe(std::vector<Segment> segments) {
  SeamDescription description;
  description.segments = std::move(segments);
  description.speed = 0.01;
  description.where = "path";
  return description;
}

JointVector posture(double x, double y, double z) {
  JointVector q(3);
  q << x, y, z;
  return q;
}

Eigen::Quaterniond random_rotation(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random))
      .normalized();
}

TEST(SeamPiece, LineTurnsAsQuaternionInterpolation) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int trial = 0; trial < 200; ++trial) {
    const Eigen::Quaterniond first = random_rotation(random), last = random_rotation(random);
    SeamPiece piece;
    piece.from = at(uniform(random), uniform(random), uniform(random)) * first;
    piece.to = at(uniform(random), uniform(random), uniform(random)) * last;
    const double f = 0.5 * (1 + uniform(random));
    const Pose frame = piece.frame_at(f);
    const Eigen::Vector3d position =
        (1 - f) * piece.from.translation() + f * piece.to.translation();
    EXPECT_LT((frame.translation() - position).norm(), 1e-14);
    EXPECT_LT((frame.linear() - first.slerp(f, last).toRotationMatrix()).norm(), 1e-12);
  }
}

TEST(SeamPiece, ArcRunsAlongTheCircleAndTurnsWithIt) {
  SeamPiece piece;
  piece.kind = SeamPiece::Kind::arc;
  piece.center << 1, 2, 3;
  piece.axis = Eigen::Vector3d::UnitZ();
  piece.angle = 3 * kPi;
  piece.from = at(1.5, 2, 0.7);
  piece.to = at(0.5, 2, 0.7);
  EXPECT_NEAR(piece.length(), 0.5 * 3 * kPi, 1e-14);
  for (const double f : {0.1, 0.25, 0.5, 0.9}) {
    const double phi = f * piece.angle;
    const Pose frame = piece.frame_at(f);
    const Eigen::Vector3d expected(1 + 0.5 * std::cos(phi), 2 + 0.5 * std::sin(phi), 0.7);
    EXPECT_LT((frame.translation() - expected).norm(), 1e-14);
    EXPECT_LT((frame.linear().col(0) - Eigen::Vector3d(std::cos(phi), std::sin(phi), 0)).norm(),
              1e-14);
  }
}

TEST(Seam, RejectsGapsInTimeAndWhatIsNotFinite) {
  SeamPiece piece;
  piece.to = at(1, 0, 0);
  piece.end_time = 1;
  SeamPiece late = piece;
  late.start_time = 1.5;
  late.end_time = 2;
  EXPECT_TRUE(says(invalid_input([&] { Seam({piece, late}); }), "piece 1"));
  EXPECT_TRUE(says(invalid_input([] { Seam(std::vector<SeamPiece>{}); }), "no pieces"));
  piece.to.translation().x() = std::nan("");
  EXPECT_TRUE(says(invalid_input([&] { Seam({piece}); }), "not finite"));
}

TEST(SeamBuilder, SpacingIsRoundedToWholeIntervalsDespiteRoundOff) {
  const std::vector<std::tuple<double, double, std::size_t>> cases = {
      {0.5, 0.005, 101}, {0.3, 0.1, 4}, {0.31, 0.1, 5}, {0.05, 0.1, 2}, {0.7, 0.1, 8}};
  for (const auto& [length, spacing, expected] : cases) {
    SeamDescription description = describe({line(at(0.1, 0, 0), at(0.1 + length, 0, 0))});
    description.spacing = spacing;
    const Task task = build_task(test::sliding_robot(), description);
    ASSERT_EQ(task.waypoints.size(), expected) << length << " / " << spacing;
    for (std::size_t i = 0; i < expected; ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(expected - 1);
      EXPECT_NEAR(task.waypoints[i].frame.translation().x(), 0.1 + share * length, 1e-15);
      EXPECT_NEAR(task.waypoints[i].time, share * length / 0.01, 1e-12);
    }
  }
}

TEST(SeamBuilder, WaypointCountIsExactAndKeepsSegmentEnds) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(0.001, 0.3);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<Segment> segments;
    std::vector<Pose> ends = {at(0, 0, 0)};
    double whole = 0;
    const int count = 1 + trial % 5;
    std::vector<double> lengths;
    for (int i = 0; i < count; ++i) {
      lengths.push_back(uniform(random));
      whole += lengths.back();
      ends.push_back(at(whole, 0, 0));
      segments.push_back(line(ends[ends.size() - 2], ends.back()));
    }
    SeamDescription description = describe(segments);
    description.waypoints = count + 1 + trial % 37;
    const Task task = build_task(test::sliding_robot(), description);
    ASSERT_EQ(task.waypoints.size(), static_cast<std::size_t>(*description.waypoints));
    std::size_t next = 0;
    for (std::size_t segment = 0; segment < lengths.size(); ++segment) {
      const std::size_t first = next;
      while ((task.waypoints[next].frame.translation() - ends[segment + 1].translation()).norm() >
             1e-12)
        ASSERT_LT(++next, task.waypoints.size()) << "the end of a segment is left out";
      const double quota = (*description.waypoints - 1) * lengths[segment] / whole;
      const auto intervals = static_cast<double>(next - first);
      EXPECT_TRUE(intervals < quota + 1 + 1e-9 || intervals == 1);
      for (std::size_t i = first; i < next; ++i)
        EXPECT_NEAR(
            (task.waypoints[i + 1].frame.translation() - task.waypoints[i].frame.translation())
                .norm(),
            lengths[segment] / intervals, 1e-12);
    }
  }
}

TEST(SeamBuilder, TooFewWaypointsForTheSegments) {
  SeamDescription description =
      describe({line(at(0, 0, 0), at(1, 0, 0)), line(at(1, 0, 0), at(1, 1, 0))});
  description.waypoints = 2;
  EXPECT_TRUE(
      says(invalid_input([&] { build_task(test::sliding_robot(), description); }), "at least 3"));
}

TEST(SeamBuilder, CornerCarriesTheFrameOfTheSegmentThatEndsThere) {
  Pose turned = at(1, 0, 0);
  turned.linear() = Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  Segment second = line(turned, at(1, 1, 0));
  second.tolerance.upper[2] = 0.25;
  SeamDescription description = describe({line(at(0, 0, 0), at(1, 0, 0)), second});
  description.spacing = 0.5;
  const Task task = build_task(test::sliding_robot(), description);
  ASSERT_EQ(task.waypoints.size(), 5u);
  EXPECT_TRUE(task.waypoints[2].frame.isApprox(at(1, 0, 0), 1e-15));
  EXPECT_TRUE(task.seam.frame_at(task.waypoints[2].time).isApprox(at(1, 0, 0), 1e-15));
  const double half_turn = Eigen::AngleAxisd(task.waypoints[3].frame.linear()).angle();
  EXPECT_NEAR(half_turn, 0.25, 1e-12);
  EXPECT_EQ(task.waypoints[2].tolerance.upper[2], 0);
  EXPECT_EQ(task.waypoints[3].tolerance.upper[2], 0.25);
  EXPECT_EQ(task.tolerance_between(1)->upper[2], 0);
  EXPECT_EQ(task.tolerance_between(2)->upper[2], 0.25);
}

TEST(SeamBuilder, GapsAreMeasured) {
  SeamDescription description =
      describe({line(at(0, 0, 0), at(1, 0, 0)), line(at(1, 2e-6, 0), at(1, 1, 0))});
  description.spacing = 0.5;
  EXPECT_TRUE(
      says(invalid_input([&] { build_task(test::sliding_robot(), description); }), "2e-06 m"));
  std::get<LineSegment>(description.segments[1].shape).from = at(1, 5e-7, 0);
  EXPECT_EQ(build_task(test::sliding_robot(), description).waypoints.size(), 5u);
}

TEST(SeamBuilder, RejectsWhatMakesNoSeam) {
  const auto message = [](Segment segment, std::optional<double> speed = 0.01) {
    SeamDescription description = describe({std::move(segment)});
    description.spacing = 0.1;
    description.speed = speed;
    return invalid_input([&] { build_task(test::sliding_robot(), description); });
  };
  const Pose start = at(1, 0, 0);
  EXPECT_TRUE(says(message(line(start, start)), "repeated waypoint"));
  EXPECT_TRUE(says(message({ArcSegment{start, {0, 0, 0}, {0, 0, 1}, 0}, {}, "arc"}), "repeated"));
  EXPECT_TRUE(says(message({ArcSegment{start, {1, 0, 5}, {0, 0, 1}, 1}, {}, "arc"}), "radius"));
  EXPECT_TRUE(says(message({PoseListSegment{{start}, {}, {"row"}}, {}, "poses"}), "one waypoint"));
  EXPECT_TRUE(says(message({PoseListSegment{{start, start}, {}, {"row 1", "row 2"}}, {}, "poses"}),
                   "row 2: repeated waypoint"));
  EXPECT_TRUE(says(message(line(start, at(0, 0, 0)), std::nullopt), "speed"));
  for (const double speed : {0.0, -0.01, std::nan("")})
    EXPECT_TRUE(says(message(line(start, at(0, 0, 0)), speed), "speed"));
}

TEST(SeamBuilder, TimesOfPosesAreKept) {
  SeamDescription description;
  description.where = "path";
  description.segments = {
      {PoseListSegment{{at(0, 0, 0), at(1, 0, 0), at(1, 1, 0)}, {5, 6, 9}, {"1", "2", "3"}},
       {},
       "poses"}};
  const Task task = build_task(test::sliding_robot(), description);
  ASSERT_EQ(task.waypoints.size(), 3u);
  EXPECT_EQ(task.waypoints[0].time, 5);
  EXPECT_EQ(task.waypoints[1].time, 6);
  EXPECT_EQ(task.waypoints[2].time, 9);
  EXPECT_TRUE(task.seam.frame_at(7.5).isApprox(at(1, 0.5, 0), 1e-15));
  description.spacing = 0.25;
  EXPECT_EQ(build_task(test::sliding_robot(), description).waypoints.size(), 9u);
}

void expect_exactly(const Waypoint& waypoint, const JointVector& q) {
  ASSERT_TRUE(waypoint.joints);
  EXPECT_EQ(waypoint.joints->lower, q);
  EXPECT_EQ(waypoint.joints->upper, q);
}

TEST(SeamBuilder, JointWaypointsAreReachedByMoves) {
  SeamDescription description =
      describe({{JointListSegment{{posture(0, 0, 0), posture(0.001, 1, 0)}, {"1", "2"}}, {}, "j"},
                line(at(0.001, 1.2, 0), at(1.001, 1.2, 0)),
                {JointListSegment{{posture(1.001, 1.2, 0.3)}, {"3"}}, {}, "j"}});
  description.speed = 2;
  description.spacing = 0.5;
  const Task task = build_task(test::sliding_robot(), description);
  ASSERT_EQ(task.waypoints.size(), 6u);
  expect_exactly(task.waypoints[0], posture(0, 0, 0));
  expect_exactly(task.waypoints[1], posture(0.001, 1, 0));
  EXPECT_FALSE(task.waypoints[2].joints);
  expect_exactly(task.waypoints[5], posture(1.001, 1.2, 0.3));
  EXPECT_LT((task.waypoints[1].frame.translation() - Eigen::Vector3d(0.001, 1, 0)).norm(), 1e-15);
  // The y axis runs at 1 m/s at most, slower than the seam's speed; elsewhere the speed decides.
  EXPECT_NEAR(task.waypoints[1].time, 1.0, 1e-12);
  EXPECT_NEAR(task.waypoints[2].time, 1.1, 1e-12);
  EXPECT_NEAR(task.waypoints[4].time, 1.6, 1e-12);
  EXPECT_NEAR(task.waypoints[5].time, 1.75, 1e-12);
  EXPECT_FALSE(task.tolerance_between(0));
  EXPECT_FALSE(task.tolerance_between(1));
  EXPECT_TRUE(task.tolerance_between(2));
  EXPECT_FALSE(task.tolerance_between(4));
}

TEST(SeamBuilder, JointWaypointsMustBePossible) {
  const auto message = [](const std::vector<JointBox>& postures) {
    SeamDescription description =
        describe({{JointListSegment{postures, {"first", "second"}}, {}, "joints"}});
    return invalid_input([&] { build_task(test::sliding_robot(), description); });
  };
  EXPECT_TRUE(says(message({posture(0, 0, 0), posture(0, 0, 0)}), "second: repeated waypoint"));
  EXPECT_TRUE(says(message({posture(0, 2.5, 0), posture(0, 0, 0)}), "y = 2.5"));
  JointVector two(2);
  two << 0, 0;
  EXPECT_TRUE(says(message({two, posture(0, 0, 0)}), "first: 2 joint values"));
  EXPECT_TRUE(says(message({{posture(0, 0, 0), two}, posture(1, 0, 0)}), "first: 2 joint values"));
  const JointBox inverted(posture(0, 0.3, 0), posture(1, 0.2, 0));
  EXPECT_TRUE(says(message({posture(0, 0, 0), inverted}),
                   "second: y: the lower bound 0.3 is above the upper, 0.2"));
  const JointBox beyond(posture(0, 0, 2.1), posture(0, 0, 3));
  const std::string outside = message({beyond, posture(0, 0, 0)});
  EXPECT_TRUE(says(outside, "first: z = [2.1, 3] is outside its limits")) << outside;
  EXPECT_TRUE(says(outside, "-2 to 2")) << outside;
  for (const double nan : {std::nan(""), -std::nan("")}) {
    EXPECT_TRUE(says(message({{posture(0, nan, 0), posture(0, 1, 0)}, posture(0, 0, 0)}),
                     "y is not a number"));
    EXPECT_TRUE(says(message({{posture(0, 0, 0), posture(0, nan, 0)}, posture(0, 0, 0)}),
                     "y is not a number"));
  }
  // The same nominal posture twice leaves no time for the move between them.
  EXPECT_TRUE(says(
      message({{posture(-1, 0, 0), posture(1, 0, 0)}, {posture(-0.5, 0, 0), posture(0.5, 0, 0)}}),
      "second: repeated waypoint"));
}

/// The range of z is cut to the limit, 2 m; the nominal posture is the middle of what is left, and
/// gives the frame and the times.
TEST(SeamBuilder, RangedJointWaypointsAreTimedByTheirNominalPosture) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  SeamDescription description =
      describe({{JointListSegment{{posture(0, 0, 0),
                                   {posture(-0.1, 0.8, 1.8), posture(0.3, 1.2, 5)},
                                   {posture(-kInfinity, 1, 1.9), posture(kInfinity, 1, 1.9)}},
                                  {"1", "2", "3"}},
                 {},
                 "j"},
                line(at(0, 1, 1.5), at(1, 1, 1.5))});
  description.speed = 4;
  description.spacing = 1;
  const Task task = build_task(test::sliding_robot(), description);
  ASSERT_EQ(task.waypoints.size(), 5u);
  const JointBox& box = *task.waypoints[1].joints;
  EXPECT_EQ(box.lower, posture(-0.1, 0.8, 1.8));
  EXPECT_EQ(box.upper, posture(0.3, 1.2, 2));
  EXPECT_LT((box.nominal() - posture(0.1, 1, 1.9)).norm(), 1e-15);
  EXPECT_EQ(task.waypoints[2].joints->lower, posture(-2, 1, 1.9));
  EXPECT_EQ(task.waypoints[2].joints->upper, posture(2, 1, 1.9));
  EXPECT_LT((task.waypoints[1].frame.translation() - Eigen::Vector3d(0.1, 1, 1.9)).norm(), 1e-15);
  // z needs 1.9 m / 1.5 m/s, x then 0.1 m / 0.5 m/s; 0.4 m to the line at 4 m/s.
  EXPECT_NEAR(task.waypoints[1].time, 1.9 / 1.5, 1e-12);
  EXPECT_NEAR(task.waypoints[2].time, 1.9 / 1.5 + 0.2, 1e-12);
  EXPECT_NEAR(task.waypoints[3].time, 1.9 / 1.5 + 0.3, 1e-12);
  const Task again = task.with_waypoints_at({0, task.waypoints[1].time, task.waypoints[2].time,
                                             task.waypoints[3].time, task.waypoints[4].time});
  EXPECT_EQ(again.waypoints[1].joints->upper, posture(0.3, 1.2, 2));
}

TEST(Task, WaypointsAtOtherTimes) {
  SeamDescription description =
      describe({line(at(0, 0, 0), at(1, 0, 0)), line(at(1, 0, 0), at(1, 1, 0))});
  description.segments[1].tolerance.upper[0] = 0.5;
  description.spacing = 0.5;
  const Task task = build_task(test::sliding_robot(), description);
  const std::vector<double> times = {-5e-7, 30, 100, 130, 200 + 5e-7};
  const Task other = task.with_waypoints_at(times);
  ASSERT_EQ(other.waypoints.size(), times.size());
  for (std::size_t i = 0; i < times.size(); ++i) EXPECT_EQ(other.waypoints[i].time, times[i]);
  EXPECT_TRUE(other.waypoints[0].frame.isApprox(at(0, 0, 0)));
  EXPECT_TRUE(other.waypoints[1].frame.isApprox(at(0.3, 0, 0), 1e-14));
  EXPECT_TRUE(other.waypoints[3].frame.isApprox(at(1, 0.3, 0), 1e-14));
  EXPECT_TRUE(other.waypoints[4].frame.isApprox(at(1, 1, 0), 1e-14));
  EXPECT_EQ(other.waypoints[2].tolerance.upper[0], 0);
  EXPECT_EQ(other.waypoints[3].tolerance.upper[0], 0.5);
  for (const std::vector<double>& bad :
       {std::vector<double>{0, 0}, {0, 1, 0.5}, {0, 200.1}, {-0.1, 3}, {3}, {0, std::nan("")}})
    invalid_input([&] { task.with_waypoints_at(bad); });
}

TEST(Task, JointWaypointsStayWhenTimesAreGiven) {
  SeamDescription description =
      describe({{JointListSegment{{posture(0, 0, 0)}, {"1"}}, {}, "joints"},
                line(at(0, 1, 0), at(1, 1, 0))});
  description.spacing = 0.5;
  const Task task = build_task(test::sliding_robot(), description);
  expect_exactly(task.with_waypoints_at({0, 100, 120}).waypoints[0], posture(0, 0, 0));
  EXPECT_TRUE(says(invalid_input([&] { task.with_waypoints_at({0, 50, 100}); }), "move"));
  EXPECT_TRUE(says(invalid_input([&] { task.with_waypoints_at({100, 150}); }), "left out"));
}

}  // namespace
}  // namespace wristwise
