// Where joints are too slow for the weld speed, stage 1 looks for a path at any speed: from the
// same samples, and with an end where there is none.

#include <gtest/gtest.h>

#include <atomic>

#include "graph_planning.hpp"
#include "timing/retiming.hpp"

namespace wristwise {
namespace {

namespace gantry = test::gantry;
using gantry::Planning;

class CountingIk final : public InverseKinematics {
 public:
  void solve(const Pose& tcp, std::vector<JointVector>& branches) const override {
    ++calls;
    exact_.solve(tcp, branches);
  }
  std::string description() const override { return "counting"; }
  mutable std::atomic<int> calls{0};

 private:
  gantry::ExactIk exact_;
};

struct Counted {
  GraphPlan plan;
  int samples = 0;
};

Counted run(Planning planning, Speed speed, int threads = 2) {
  const SamplingInput own = planning.input();
  const CountingIk ik;
  const SamplingInput input{own.robot, ik, own.clearance, own.cost, own.options};
  Timing timing;
  Counted counted;
  counted.plan = plan_graph(input, planning.task, 5e-5, threads, {}, timing, speed);
  counted.samples = ik.calls;
  return counted;
}

/// One interval a second, y free to 0.4 m: `speed` (m/s) is what the slide has along y.
Planning with_slow_slide(double speed, double step) {
  Planning planning;
  planning.allow(1, 0.4, step);
  planning.parts.joints[1].max_velocity = speed;
  planning.options.max_stray = gantry::kUnlimited;
  planning.options.try_relaxations = false;
  return planning;
}

/// The tolerance is on one side of the seam, and on the other one waypoint later.
Planning with_jump() {
  Planning planning = with_slow_slide(0.1, 0.1);
  for (std::size_t i = 0; i < planning.task.waypoints.size(); ++i) {
    ToleranceBox& box = planning.task.waypoints[i].tolerance;
    (i < 10 ? box.upper : box.lower)[1] = i < 10 ? -0.2 : 0.2;
  }
  return planning;
}

/// No way through, whatever the speed: every posture is clear, every move in one interval blocked.
Planning with_wall() {
  Planning planning = with_slow_slide(0.05, 0.004);
  planning.parts.links[0].collision[0].geometry = Sphere{0.005};
  planning.objects = {gantry::obstacle(Box{{0.002, 4, 4}}, 0.525, 0, 0)};
  return planning;
}

TEST(PathAtAnySpeed, IsFoundInTheSamplesThatWereThere) {
  const Counted held = run(with_jump(), Speed::hold);
  EXPECT_FALSE(held.plan.found);
  const Counted any = run(with_jump(), Speed::any);
  ASSERT_TRUE(any.plan.found);
  EXPECT_TRUE(any.plan.too_fast);
  EXPECT_FALSE(any.plan.diagnosis);
  EXPECT_EQ(any.samples, 21 * 3 + 3);  // and a waypoint's once more, to say why it is too fast

  Planning slower = with_jump();
  slower.task = stretched(slower.task, 100);
  const Counted oracle = run(slower, Speed::hold);
  ASSERT_TRUE(oracle.plan.found);
  EXPECT_FALSE(oracle.plan.too_fast);
  EXPECT_EQ(any.plan.seeds.front().path.positions, oracle.plan.seeds.front().path.positions);
  EXPECT_EQ(any.plan.seeds.front().cost, oracle.plan.seeds.front().cost);
  for (std::size_t i = 0; i < 21; ++i) {
    EXPECT_EQ(any.plan.seeds.front().path.times[i], with_jump().task.waypoints[i].time);
  }
}

TEST(PathAtAnySpeed, IsNotLookedForWhereTheJointsKeepUp) {
  Planning planning = with_jump();
  planning.parts.joints[1].max_velocity = 1;
  const Counted any = run(planning, Speed::any), held = run(planning, Speed::hold);
  ASSERT_TRUE(any.plan.found && held.plan.found);
  EXPECT_FALSE(any.plan.too_fast);
  EXPECT_EQ(any.plan.statistics.collision_checks, held.plan.statistics.collision_checks);
  EXPECT_EQ(any.plan.seeds.front().path.positions, held.plan.seeds.front().path.positions);
}

/// Of 200 x 200 moves through the wall about 5000 are slow enough; the rest is not worth a look.
TEST(PathAtAnySpeed, IsGivenUpWhereThereIsNone) {
  const Counted held = run(with_wall(), Speed::hold, 1);
  ASSERT_FALSE(held.plan.found);
  const GraphStatistics& of_held = held.plan.statistics;
  ASSERT_GT(of_held.edges_checked, 4000U);
  ASSERT_LT(of_held.edges_checked, 6000U);
  const Counted any = run(with_wall(), Speed::any, 1);
  ASSERT_FALSE(any.plan.found);
  EXPECT_FALSE(any.plan.too_fast);
  EXPECT_EQ(any.samples, held.samples);
  const double queries_of_a_move =
      static_cast<double>(of_held.collision_checks) / static_cast<double>(of_held.edges_checked);
  EXPECT_LE(static_cast<double>(any.plan.statistics.collision_checks - of_held.collision_checks),
            1.5 * 10000 * queries_of_a_move);
  // It ends as it does at weld speed.
  ASSERT_TRUE(any.plan.diagnosis && held.plan.diagnosis);
  EXPECT_EQ(any.plan.diagnosis->detail, held.plan.diagnosis->detail);
  EXPECT_EQ(any.plan.statistics.pieces, held.plan.statistics.pieces);
  EXPECT_EQ(any.plan.seeds.front().path.positions, held.plan.seeds.front().path.positions);
}

TEST(PathAtAnySpeed, DoesNotDependOnTheThreads) {
  for (const auto& planning : {with_jump(), with_wall()}) {
    const Counted one = run(planning, Speed::any, 1), four = run(planning, Speed::any, 4);
    EXPECT_EQ(one.plan.found, four.plan.found);
    EXPECT_EQ(one.plan.seeds.front().path.positions, four.plan.seeds.front().path.positions);
    EXPECT_EQ(one.samples, four.samples);
  }
}

/// The sparse planner leaves it to the dense one.
TEST(PathAtAnySpeed, IsFoundForTheSparsePlannerToo) {
  Planning planning = with_jump();
  planning.options.planner = Planner::sparse;
  const Counted any = run(planning, Speed::any);
  ASSERT_TRUE(any.plan.found);
  EXPECT_TRUE(any.plan.too_fast);
  EXPECT_EQ(any.plan.seeds.size(), 1U);
  EXPECT_EQ(any.plan.seeds.front().path.size(), 21U);
  EXPECT_FALSE(any.plan.diagnosis);
}

}  // namespace
}  // namespace wristwise
