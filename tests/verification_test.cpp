#include "wristwise/verification.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "gantry.hpp"
#include "invalid_input.hpp"

namespace wristwise {
namespace {

namespace gantry = test::gantry;
using test::invalid_input;
using test::says;

constexpr double kDuration = 10;  // s
constexpr int kIntervals = 10;
constexpr std::size_t kFaulty = 4;  // the waypoint at 4 s that faults are planted at

/// 1 m along x at a constant speed; position held to 1 mm, angles to 0.1 rad.
Task straight_task() {
  return gantry::task({{0, 0, 0}, {1, 0, 0}}, kDuration, kIntervals, gantry::box(1e-3, 0.1));
}

Verification check(const Task& task, const JointPath& path) {
  return verify(task, gantry::clearance(gantry::robot()), path);
}
Verification check(const Task& task, const Trajectory& trajectory) {
  return verify(task, gantry::clearance(gantry::robot()), trajectory);
}

/// Positions, velocities and accelerations that can be tampered with before they become a curve.
struct Nodes {
  JointPath path;
  std::vector<JointVector> velocities, accelerations;

  explicit Nodes(const Task& task)
      : path(gantry::path_along(task)),
        velocities(path.size(), gantry::posture(1 / kDuration, 0, 0)),
        accelerations(path.size(), gantry::posture(0, 0, 0)) {}
  Trajectory curve() const { return {path.times, path.positions, velocities, accelerations}; }
};

void expect_clean(const Verification& result) {
  EXPECT_TRUE(result.run);
  EXPECT_TRUE(result.passed);
  EXPECT_TRUE(result.failures.empty()) << result.failures.front();
  EXPECT_TRUE(result.warnings.empty()) << result.warnings.front();
}

/// Exactly one failure, which names all parts.
void expect_failure(const Verification& result, const std::vector<std::string>& parts) {
  EXPECT_FALSE(result.passed);
  ASSERT_EQ(result.failures.size(), 1U) << ::testing::PrintToString(result.failures);
  for (const std::string& part : parts) {
    EXPECT_TRUE(says(result.failures[0], part)) << result.failures[0] << " lacks " << part;
  }
}

/// The number behind the first bracket.
double time_in(const std::string& failure) {
  return std::stod(failure.substr(failure.find('(') + 1));
}

TEST(Verification, StartsAsNotRun) {
  EXPECT_FALSE(Verification{}.run);
  EXPECT_FALSE(Verification{}.passed);
}

TEST(Verification, PassesWhatIsClean) {
  const Task task = straight_task();
  const Verification points = check(task, gantry::path_along(task));
  expect_clean(points);
  EXPECT_FALSE(points.curve);
  EXPECT_FALSE(points.clearance.has_value());
  const Verification curve = check(task, Nodes(task).curve());
  expect_clean(curve);
  EXPECT_TRUE(curve.curve);
  for (const Verification& result : {points, curve}) {
    EXPECT_TRUE(result.deviation_shown);
    EXPECT_EQ(result.range.from, 0);
    EXPECT_EQ(result.range.to, kDuration);
    EXPECT_LT(result.path_error, 2e-6);
    EXPECT_LT(result.angle_error, 2e-6);
  }
}

TEST(Verification, PassesAtTheEdgeOfTheTolerance) {
  const Task task = straight_task();
  Nodes nodes(task);
  for (JointVector& q : nodes.path.positions) q += gantry::posture(1e-3, -1e-3, 1e-3, 0.1);
  expect_clean(check(task, nodes.path));
  expect_clean(check(task, nodes.curve()));
  for (JointVector& q : nodes.path.positions) q[2] += 0.9e-6;
  expect_clean(check(task, nodes.path));
  expect_clean(check(task, nodes.curve()));
}

/// 2e-6 m or rad beyond the box at one waypoint, on every coordinate and side the gantry has.
TEST(Verification, CatchesAWaypointOutsideItsBox) {
  const Task task = straight_task();
  const std::vector<std::string> names = {"x is 0.002 mm", "y is 0.002 mm", "z is 0.002 mm",
                                          "rx is 0.0001146 deg"};
  for (int k = 0; k < 4; ++k) {
    for (const double sign : {1.0, -1.0}) {
      Nodes nodes(task);
      const double excess = 2e-6;
      nodes.path.positions[kFaulty][k] += sign * ((k < 3 ? 1e-3 : 0.1) + excess);
      for (const Verification& result : {check(task, nodes.path), check(task, nodes.curve())}) {
        expect_failure(result,
                       {"waypoint 4 (4 s)", names[static_cast<std::size_t>(k)], "tolerance"});
        EXPECT_NEAR(result.tolerance_excess[k], excess, 1e-12);
        EXPECT_NEAR(result.position_error, k < 3 ? excess : 0, 1e-12);
      }
    }
  }
}

/// A quintic with y' = v at one end of an interval of 1 s and -v at the other leaves the line by
/// 0.3125 v in the middle, and by less in the neighbours.
TEST(Verification, CatchesACurveThatLeavesTheSeamBetweenWaypoints) {
  const Task task = straight_task();
  Nodes nodes(task);
  const double v = (1e-3 + task.between_position + 5e-6) / 0.3125;
  nodes.velocities[kFaulty][1] = v;
  nodes.velocities[kFaulty + 1][1] = -v;
  const Verification result = check(task, nodes.curve());
  expect_failure(result, {"between waypoints (", "y is 0.00"});
  if (HasFatalFailure()) return;
  EXPECT_NEAR(time_in(result.failures[0]), 4.5, 0.01);
  EXPECT_EQ(result.tolerance_excess, Vector6::Zero());
  EXPECT_NEAR(result.tolerance_excess_between[1], 5e-6, 1e-6);

  nodes.velocities[kFaulty][1] = 0.99 * v;
  nodes.velocities[kFaulty + 1][1] = -0.99 * v;
  expect_clean(check(task, nodes.curve()));
}

TEST(Verification, CatchesACurveThatTurnsTooFarBetweenWaypoints) {
  const Task task = straight_task();
  Nodes nodes(task);
  const double v = (0.1 + task.between_angle + 1e-4) / 0.3125;
  nodes.velocities[kFaulty][3] = v;
  nodes.velocities[kFaulty + 1][3] = -v;
  const Verification result = check(task, nodes.curve());
  expect_failure(result, {"between waypoints (", "rx is 0.005"});
  if (HasFatalFailure()) return;
  EXPECT_NEAR(time_in(result.failures[0]), 4.5, 0.01);
}

/// Points cut a corner of the seam: the deviation between them is a warning.
TEST(Verification, DeviationBetweenPointsIsAWarning) {
  Task task = straight_task();
  SeamPiece piece = task.seam.pieces().front();
  piece.kind = SeamPiece::Kind::arc;
  piece.center << 0.5, 0, 0;
  piece.axis = -Eigen::Vector3d::UnitZ();
  piece.angle = std::acos(-1.0);
  task.seam = Seam({piece});
  JointPath path;
  for (Waypoint& waypoint : task.waypoints) {
    waypoint.frame = task.seam.frame_at(waypoint.time);
    // The seam turns about z, which the gantry can't.
    waypoint.tolerance = gantry::box(1e-3, 0.1);
    waypoint.tolerance.lower[5] = -gantry::kUnlimited;
    waypoint.tolerance.upper[5] = gantry::kUnlimited;
  }
  path = gantry::path_along(task);
  const Verification result = check(task, path);
  EXPECT_TRUE(result.passed);
  const double sagitta = 0.5 * (1 - std::cos(std::acos(-1.0) / (2 * kIntervals)));
  ASSERT_FALSE(result.warnings.empty());
  EXPECT_TRUE(says(result.warnings[0], "between waypoints ("));
  EXPECT_GT(result.tolerance_excess_between.head<2>().maxCoeff(), 0.5 * sagitta - 1.1e-3);
  EXPECT_LT(result.tolerance_excess_between.head<2>().maxCoeff(), sagitta);
}

TEST(Verification, CatchesAPathThatIsTooShort) {
  const Task task = straight_task();
  for (const bool at_start : {true, false}) {
    JointPath path = gantry::path_along(task);
    if (at_start) {
      path.times.erase(path.times.begin());
      path.positions.erase(path.positions.begin());
    } else {
      path.times.pop_back();
      path.positions.pop_back();
    }
    expect_failure(check(task, path), {at_start ? "runs from 1 s to 10 s" : "runs from 0 s to 9 s",
                                       "the seam from 0 s to 10 s"});
  }
}

/// Two rows that are on the seam of two lines only at its ends.
TEST(Verification, CatchesSkippedWaypoints) {
  const Task task =
      gantry::task({{0, 0, 0}, {0.5, 0.5, 0}, {1, 0, 0}}, kDuration, 5, gantry::box(1e-3, 0.1));
  const JointPath path{{0, kDuration}, {gantry::posture(0, 0, 0), gantry::posture(1, 0, 0)}};
  const Verification result = check(task, path);
  EXPECT_FALSE(result.passed);
  ASSERT_EQ(result.failures.size(), 9U);
  EXPECT_TRUE(says(result.failures[4], "waypoint 5 of the problem (5 s) has no row"));
  EXPECT_TRUE(says(result.failures[4], "y is 498.9 mm outside"));
  const Trajectory curve(path.times, path.positions,
                         {gantry::posture(0.1, 0, 0), gantry::posture(0.1, 0, 0)},
                         {gantry::posture(0, 0, 0), gantry::posture(0, 0, 0)});
  EXPECT_FALSE(check(task, curve).passed);
}

/// Fewer and other rows than waypoints are fine where they are on the seam.
TEST(Verification, PassesOtherTimesOnTheSeam) {
  const Task task = straight_task();
  expect_clean(check(task, JointPath{{0, 3.3, 7.7, kDuration},
                                     {gantry::posture(0, 0, 0), gantry::posture(0.33, 0, 0),
                                      gantry::posture(0.77, 0, 0), gantry::posture(1, 0, 0)}}));
}

TEST(Verification, CatchesAWrongJointWaypoint) {
  Task task = straight_task();
  task.waypoints[kFaulty].joints = gantry::posture(0.4, 0, 0);
  Nodes nodes(task);
  expect_clean(check(task, nodes.path));
  expect_clean(check(task, nodes.curve()));
  // Inside the box of the neighbours, but not the posture that is given.
  nodes.path.positions[kFaulty][1] += 2e-6;
  expect_failure(check(task, nodes.path), {"waypoint 4 (4 s)", "y is 2e-06 off the posture"});
  expect_failure(check(task, nodes.curve()), {"waypoint 4 (4 s)", "y is 2e-06 off the posture"});
}

/// y may be in [0.1 m, 0.3 m], to 1e-9 m as with joint limits; x, z and the tilt have one value.
TEST(Verification, HoldsTheRangesOfAJointWaypoint) {
  Task task = straight_task();
  task.waypoints[kFaulty].joints =
      JointBox(gantry::posture(0.4, 0.1, 0), gantry::posture(0.4, 0.3, 0));
  for (Waypoint& waypoint : task.waypoints) waypoint.tolerance = gantry::box(1, 1);
  Nodes nodes(task);
  const auto set_y = [&](double y) { nodes.path.positions[kFaulty][1] = y; };
  for (const double y : {0.1, 0.1 - 5e-10, 0.2, 0.3 + 5e-10, 0.3}) {
    set_y(y);
    expect_clean(check(task, nodes.path));
    expect_clean(check(task, nodes.curve()));
  }
  const std::string range = "outside its range [0.1, 0.3]";
  for (const auto& [y, excess] : {std::pair{0.1 - 2e-9, "2e-09"}, std::pair{0.3 + 2e-9, "2e-09"},
                                  std::pair{0.05, "0.05"}, std::pair{0.0, "0.1"}}) {
    set_y(y);
    const std::string amount = std::string("y is ") + excess;
    expect_failure(check(task, nodes.path), {"waypoint 4 (4 s)", amount, range});
    expect_failure(check(task, nodes.curve()), {"waypoint 4 (4 s)", amount, range});
  }
  set_y(0.2);
  nodes.path.positions[kFaulty][3] = 0.01;
  expect_failure(check(task, nodes.path), {"tilt is 0.01 off the posture"});
}

/// Between a range and a value there is no gap: within 1e-6 of the middle is near enough.
TEST(Verification, ATinyRangeIsHeldLikeAValue) {
  Task task = straight_task();
  task.waypoints[kFaulty].joints =
      JointBox(gantry::posture(0.4, -1e-8, 0), gantry::posture(0.4, 1e-8, 0));
  Nodes nodes(task);
  nodes.path.positions[kFaulty][1] = 9e-7;
  expect_clean(check(task, nodes.path));
  nodes.path.positions[kFaulty][1] = 2e-6;
  expect_failure(check(task, nodes.path), {"y is 1.99e-06 outside its range"});
}

TEST(Verification, RejectsAJointWaypointThatFitsNoRobot) {
  Task task = straight_task();
  const JointPath path = gantry::path_along(task);
  const auto message = [&](const JointBox& box) {
    task.waypoints[kFaulty].joints = box;
    return invalid_input([&] { check(task, path); });
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(says(message(JointVector(JointVector::Zero(3))), "waypoint 4: 3 joint values"));
  EXPECT_TRUE(says(message(gantry::posture(0, nan, 0)), "waypoint 4: y is not a number"));
  EXPECT_TRUE(says(message(gantry::posture(3, 0, 0)), "waypoint 4: x = 3 is outside its limits"));
  EXPECT_TRUE(says(message({gantry::posture(1, 0, 0), gantry::posture(0, 0, 0)}),
                   "waypoint 4: x: the lower bound 1 is above the upper, 0"));
}

TEST(Verification, RejectsALeftOutJointWaypoint) {
  Task task = straight_task();
  task.waypoints[kFaulty].joints = gantry::posture(0.4, 0, 0);
  JointPath path = gantry::path_along(task);
  path.times.erase(path.times.begin() + kFaulty);
  path.positions.erase(path.positions.begin() + kFaulty);
  EXPECT_TRUE(says(invalid_input([&] { check(task, path); }), "joint waypoint"));
}

TEST(Verification, RejectsWhatIsNoPath) {
  const Task task = straight_task();
  const JointPath clean = gantry::path_along(task);
  const auto expect_invalid = [&](const JointPath& path) {
    EXPECT_FALSE(invalid_input([&] { check(task, path); }).empty());
  };
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), gantry::kUnlimited}) {
    JointPath path = clean;
    path.positions[3][1] = bad;
    expect_invalid(path);
    path = clean;
    path.times[3] = bad;
    expect_invalid(path);
  }
  JointPath path = clean;
  std::swap(path.times[3], path.times[4]);
  expect_invalid(path);
  path = clean;
  path.positions[3] = JointVector::Zero(3);
  expect_invalid(path);
  path = clean;
  path.times.back() += 1;
  expect_invalid(path);
  expect_invalid({});
  EXPECT_FALSE(invalid_input([&] { check(task, Trajectory()); }).empty());
  Nodes nodes(task);
  nodes.velocities[2][0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(invalid_input([&] { check(task, nodes.curve()); }).empty());
}

}  // namespace
}  // namespace wristwise
