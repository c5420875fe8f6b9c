#include "graph/diagnosis.hpp"

#include <gtest/gtest.h>

#include "gantry.hpp"
#include "invalid_input.hpp"

namespace wristwise {
namespace {

namespace gantry = test::gantry;
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

struct Moves {
  SampledPath sampled;
  EdgeRules rules;
  LadderPath path;

  /// From x = 0 at the second waypoint to the given postures at the third.
  explicit Moves(const std::vector<JointVector>& next, double max_step) {
    for (int i = 0; i < 5; ++i) sampled.rungs.push_back(rung_of({gantry::posture(0, 0, 0)}));
    sampled.rungs[2] = rung_of(next);
    sampled.counts.resize(5);
    rules.weight = JointVector::Ones(4);
    rules.max_step.assign(4, JointVector::Constant(4, max_step));
    path.vertices = {0, 0};
  }
};

Diagnosis diagnose(const Moves& moves, const std::shared_ptr<const ClearanceModel>& clearance,
                   double max_stray = gantry::kUnlimited) {
  const MoveChecker checker(task(), clearance, max_stray, 5e-5, 1);
  return diagnose_moves(task(), moves.sampled, moves.rules, moves.path, checker, clearance, 5e-5);
}

TEST(DiagnoseMoves, NamesTheJointThatIsTooSlow) {
  const Moves moves({gantry::posture(0.5, 0.4, 0, 0), gantry::posture(0, 0.3, 0.1, 0)}, 0.2);
  const Diagnosis diagnosis = diagnose(moves, gantry::clearance(gantry::robot()));
  EXPECT_EQ(diagnosis.waypoint, 2U);
  EXPECT_EQ(diagnosis.reason, "no_edge");
  EXPECT_TRUE(says(diagnosis.detail, "waypoint 2 (2 s)")) << diagnosis.detail;
  EXPECT_TRUE(says(diagnosis.detail, "from waypoint 1")) << diagnosis.detail;
  EXPECT_TRUE(says(diagnosis.detail, "1.50 times the speed of y")) << diagnosis.detail;
}

/// A post between the only vertex and both that follow.
TEST(DiagnoseMoves, NamesThePairThatBlocksTheNearestMove) {
  const Moves moves({gantry::posture(1, 0, 0), gantry::posture(1.1, 0, 0)}, gantry::kUnlimited);
  SceneObject post = gantry::obstacle(Cylinder{0.05, 4}, 0.5, 0, 0);
  post.name = "post";
  const Diagnosis diagnosis = diagnose(moves, gantry::clearance(gantry::robot(), {post}, 0.01));
  EXPECT_EQ(diagnosis.waypoint, 2U);
  EXPECT_EQ(diagnosis.reason, "collision");
  EXPECT_TRUE(says(diagnosis.detail, "ball - post")) << diagnosis.detail;
  EXPECT_TRUE(says(diagnosis.detail, "from waypoint 1")) << diagnosis.detail;
  EXPECT_FALSE(diagnosis.suggestion.empty());
}

/// The seam is at x = 0.4375 at three quarters of the stretch, held to 0.1 m; the moves are at 0.75
/// and 0.825 then.
TEST(DiagnoseMoves, SaysHowFarTheTcpStrays) {
  const Moves moves({gantry::posture(1.1, 0, 0), gantry::posture(1, 0, 0)}, gantry::kUnlimited);
  const Diagnosis diagnosis = diagnose(moves, gantry::clearance(gantry::robot()), 0.01);
  EXPECT_EQ(diagnosis.waypoint, 2U);
  EXPECT_EQ(diagnosis.reason, "no_edge");
  EXPECT_TRUE(says(diagnosis.detail, "by 212.5 mm")) << diagnosis.detail;
  EXPECT_TRUE(says(diagnosis.suggestion, "max_stray")) << diagnosis.suggestion;
}

}  // namespace
}  // namespace wristwise
