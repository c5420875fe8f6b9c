#include "graph/diagnosis.hpp"

#include <gtest/gtest.h>

#include "graph_planning.hpp"
#include "invalid_input.hpp"

namespace wristwise {
namespace {

namespace gantry = test::gantry;
using gantry::Planning;
using test::says;

Rung rung_of(const std::vector<JointVector>& postures) {
  Rung rung;
  rung.positions.resize(static_cast<Eigen::Index>(postures.size()), 4);
  for (std::size_t v = 0; v < postures.size(); ++v) {
    rung.positions.row(static_cast<Eigen::Index>(v)) = postures[v].transpose().array();
  }
  rung.cost.setZero(rung.positions.rows());
  return rung;
}

Task task() { return gantry::task({{0, 0, 0}, {1, 0, 0}}, 4, 4, gantry::box(0.1, 0.1)); }

/// One vertex at every waypoint but the given one.
SampledPath empty_at(std::size_t waypoint, const SampleCounts& counts) {
  SampledPath sampled;
  for (std::size_t i = 0; i < 5; ++i) {
    sampled.rungs.push_back(i == waypoint ? rung_of({}) : rung_of({gantry::posture(0, 0, 0)}));
    sampled.counts.emplace_back();
    sampled.counts[i].samples = 10;
  }
  sampled.counts[waypoint] = counts;
  return sampled;
}

TEST(DiagnoseSamples, SaysNothingWhereEveryWaypointHasAVertex) {
  SampledPath sampled = empty_at(0, {});
  sampled.rungs[0] = rung_of({gantry::posture(0, 0, 0)});
  EXPECT_FALSE(diagnose_samples(*gantry::robot(), task(), sampled).has_value());
}

TEST(DiagnoseSamples, NamesTheFirstWaypointAndItsReason) {
  SampleCounts counts;
  counts.samples = 12;
  counts.out_of_reach = 12;
  const auto unreachable = diagnose_samples(*gantry::robot(), task(), empty_at(2, counts));
  ASSERT_TRUE(unreachable.has_value());
  EXPECT_EQ(unreachable->waypoint, 2U);
  EXPECT_EQ(unreachable->reason, "out_of_reach");
  EXPECT_TRUE(says(unreachable->detail, "waypoint 2 (2 s)")) << unreachable->detail;
  EXPECT_TRUE(says(unreachable->detail, "12 samples 12 are out of reach")) << unreachable->detail;
  EXPECT_FALSE(unreachable->suggestion.empty());

  counts.out_of_reach = 5;
  counts.joint_limit = {{0, 3}, {3, 9}};
  const auto limited = diagnose_samples(*gantry::robot(), task(), empty_at(1, counts));
  ASSERT_TRUE(limited.has_value());
  EXPECT_EQ(limited->waypoint, 1U);
  EXPECT_EQ(limited->reason, "joint_limit");
  EXPECT_TRUE(says(limited->detail, "that of tilt")) << limited->detail;
  EXPECT_TRUE(says(limited->detail, "12 branches break a joint limit")) << limited->detail;
  ASSERT_TRUE(limited->counts.has_value());
  const std::map<std::string, std::size_t> by_name = {{"x", 3}, {"tilt", 9}};
  EXPECT_EQ(limited->counts->joint_limit, by_name);

  counts.collision = {{{"ball", "plate"}, 4}, {{"ball", "post"}, 7}};
  const auto colliding = diagnose_samples(*gantry::robot(), task(), empty_at(0, counts));
  ASSERT_TRUE(colliding.has_value());
  EXPECT_EQ(colliding->waypoint, 0U);
  EXPECT_EQ(colliding->reason, "collision");
  EXPECT_TRUE(says(colliding->detail, "ball - post")) << colliding->detail;
  EXPECT_TRUE(says(colliding->detail, "11 collide")) << colliding->detail;
}

TEST(DiagnoseSamples, OfAJointWaypointSpeaksOfItsRanges) {
  Task with_joints = task();
  with_joints.waypoints[2].joints = gantry::posture(0, 0, 0);
  SampleCounts counts;
  counts.samples = 1;
  counts.collision = {{{"ball", "post"}, 1}};
  const auto colliding = diagnose_samples(*gantry::robot(), with_joints, empty_at(2, counts));
  ASSERT_TRUE(colliding.has_value());
  EXPECT_TRUE(says(colliding->detail, "ball - post")) << colliding->detail;
  EXPECT_TRUE(says(colliding->suggestion, "ranges of its joints")) << colliding->suggestion;
  EXPECT_FALSE(says(colliding->suggestion, "tolerance")) << colliding->suggestion;
}

/// The ball of radius 0.05 m passes at 0.05 m a step; a post of radius 0.1 m stands on the seam at
/// x = 0.5, so that the waypoints 8 to 12 (x = 0.4 .. 0.6) collide.
Planning past_a_post() {
  Planning planning;
  SceneObject post = gantry::obstacle(Cylinder{0.1, 4}, 0.5, 0, 0);
  post.name = "post";
  planning.objects = {post};
  return planning;
}

TEST(Diagnosis, NamesThePairAndThePiecesThatCanBeWelded) {
  const GraphPlan plan = past_a_post().plan();
  EXPECT_FALSE(plan.found);
  ASSERT_TRUE(plan.diagnosis.has_value());
  EXPECT_EQ(plan.diagnosis->waypoint, 8U);
  EXPECT_EQ(plan.diagnosis->reason, "collision");
  EXPECT_TRUE(says(plan.diagnosis->detail, "ball - post")) << plan.diagnosis->detail;
  const std::vector<std::pair<std::size_t, std::size_t>> pieces = {{0, 7}, {13, 20}};
  EXPECT_EQ(plan.statistics.pieces, pieces);
  EXPECT_TRUE(says(plan.diagnosis->detail, "0 to 7, 13 to 20")) << plan.diagnosis->detail;
  ASSERT_TRUE(plan.diagnosis->counts.has_value());
  EXPECT_EQ(plan.diagnosis->counts->samples, 1U);
  EXPECT_EQ(plan.diagnosis->counts->collision.begin()->second, 1U);
  EXPECT_EQ(plan.diagnosis->counts->usable, 0U);
  EXPECT_EQ(plan.seeds.front().path.size(), 8U);
}

/// More than 0.15 m to the side are needed at x = 0.5; widths are tried in steps of 0.5 mm. z does
/// not help, as the post is higher than the gantry reaches.
TEST(Diagnosis, FindsTheSmallestWiderTolerance) {
  Planning planning = past_a_post();
  planning.allow(1, 0.13, 0.05);
  const GraphPlan plan = planning.plan();
  ASSERT_TRUE(plan.diagnosis.has_value());
  EXPECT_TRUE(says(plan.diagnosis->suggestion, "y +-150.5 mm instead of +-130 mm"))
      << plan.diagnosis->suggestion;
  EXPECT_TRUE(says(plan.diagnosis->suggestion, "enough for the whole seam"));
  EXPECT_FALSE(says(plan.diagnosis->suggestion, " z ")) << plan.diagnosis->suggestion;
  planning.allow(1, 0.1505, 0.05);
  EXPECT_TRUE(planning.plan().found);
  planning.allow(1, 0.15, 0.05);
  EXPECT_FALSE(planning.plan().found);
}

/// A coordinate that was held has no step yet: the suggestion names the one that was tried.
TEST(Diagnosis, NamesTheStepOfACoordinateThatWasHeld) {
  Planning planning = past_a_post();
  planning.objects[0].shapes[0].pose.translation().y() = 0.13;  // y < -0.02 is clear
  const GraphPlan plan = planning.plan();
  ASSERT_TRUE(plan.diagnosis.has_value());
  EXPECT_TRUE(says(plan.diagnosis->suggestion, "y +-20.5 mm instead of 0 mm"))
      << plan.diagnosis->suggestion;
  EXPECT_FALSE(plan.found);
  const std::string& text = plan.diagnosis->suggestion;
  ASSERT_TRUE(says(text, "graph.samples.y"));
  planning.allow(1, 0.0205, std::stod(text.substr(text.find("samples.y") + 10)) / 1000);
  EXPECT_TRUE(planning.plan().found);
}

/// A wall along the seam at 0.06 m from the ball, of which 0.08 m are required.
TEST(Diagnosis, FindsTheSmallestClearanceToGiveUp) {
  Planning planning;
  planning.objects = {gantry::obstacle(Box{{10, 0.1, 10}}, 0, 0.16, 0)};
  planning.required = 0.08;
  const GraphPlan plan = planning.plan();
  ASSERT_TRUE(plan.diagnosis.has_value());
  EXPECT_EQ(plan.diagnosis->waypoint, 0U);
  EXPECT_TRUE(says(plan.diagnosis->suggestion, "scene.clearance 56 mm instead of 80 mm"))
      << plan.diagnosis->suggestion;
}

/// x moves 0.05 m a second, 0.03 m/s are allowed: 1.67 times the time; the powers of 1.1 are tried,
/// of which 1.1^6 = 1.77 is the first that is enough.
TEST(Diagnosis, FindsTheSpeedThatTheJointsCanKeep) {
  Planning planning;
  planning.parts.joints[0].max_velocity = 0.03;
  const GraphPlan plan = planning.plan();
  ASSERT_TRUE(plan.diagnosis.has_value());
  EXPECT_EQ(plan.diagnosis->reason, "no_edge");
  EXPECT_EQ(plan.diagnosis->waypoint, 1U);
  EXPECT_TRUE(says(plan.diagnosis->detail, "1.67 times the speed of x")) << plan.diagnosis->detail;
  EXPECT_EQ(plan.diagnosis->counts->usable, 1U);
  EXPECT_EQ(plan.diagnosis->counts->too_fast, 1U);
  EXPECT_TRUE(says(plan.diagnosis->suggestion, "1.77 times the time"))
      << plan.diagnosis->suggestion;
}

/// y = +-0.3 only, and a wall at y = 0 with a gap of one interval: every move through the gap is
/// astray, every other one is blocked.
TEST(Diagnosis, CountsMovesThatStrayAndMovesThatAreBlocked) {
  Planning planning;
  planning.allow(1, 0.3, 0.6);
  planning.options.max_stray = 0.01;
  planning.objects = {gantry::obstacle(Box{{0.4, 0.4, 4}}, 0.3, 0.3, 0),
                      gantry::obstacle(Box{{0.4, 0.4, 4}}, 0.8, -0.3, 0),
                      gantry::obstacle(Box{{0.02, 0.3, 4}}, 0.55, 0, 0)};
  planning.objects[1].name = "second";
  planning.objects[2].name = "third";
  const GraphPlan plan = planning.plan();
  EXPECT_FALSE(plan.found);
  ASSERT_TRUE(plan.diagnosis.has_value());
  ASSERT_TRUE(plan.diagnosis->counts.has_value());
  const FailureCounts& counts = *plan.diagnosis->counts;
  EXPECT_GT(counts.usable, 0U);
  EXPECT_EQ(counts.usable, counts.too_fast + counts.too_far + counts.astray + counts.blocked);
  EXPECT_GT(counts.blocked, 0U);
  EXPECT_EQ(plan.statistics.pieces.size(), 2U);
}

TEST(Diagnosis, SaysHowFarTheTcpStrays) {
  Planning planning;
  // The waypoints at half the seam are asked for elsewhere than the seam passes.
  planning.options.max_stray = 0.01;
  for (std::size_t i = 10; i < planning.task.waypoints.size(); ++i) {
    planning.task.waypoints[i].frame.translation().y() = 0.2;
  }
  const GraphPlan plan = planning.plan();
  ASSERT_TRUE(plan.diagnosis.has_value());
  EXPECT_EQ(plan.diagnosis->reason, "no_edge");
  EXPECT_EQ(plan.diagnosis->waypoint, 10U);
  EXPECT_TRUE(says(plan.diagnosis->detail, "by 150.0 mm")) << plan.diagnosis->detail;
  EXPECT_EQ(plan.diagnosis->counts->astray, 1U);
}

/// The TCP goes 0.05 m from waypoint to waypoint.
TEST(Diagnosis, NamesTheLimitOfTheToolsStep) {
  Planning planning;
  planning.options.max_tcp_step = 0.051;
  EXPECT_TRUE(planning.plan().found);
  planning.options.max_tcp_step = 0.049;
  const GraphPlan plan = planning.plan();
  EXPECT_FALSE(plan.found);
  ASSERT_TRUE(plan.diagnosis.has_value());
  EXPECT_EQ(plan.diagnosis->waypoint, 1U);
  EXPECT_EQ(plan.diagnosis->counts->too_far, 1U);
  EXPECT_TRUE(says(plan.diagnosis->detail, "max_tcp_step")) << plan.diagnosis->detail;
}

}  // namespace
}  // namespace wristwise
