#include "graph/path_sampling.hpp"

#include <gtest/gtest.h>

#include <atomic>

#include "cancelled.hpp"
#include "gantry.hpp"
#include "graph/turn_copies.hpp"
#include "kuka_kr5_arc.hpp"
#include "wristwise/kinematics.hpp"

namespace wristwise {
namespace {

namespace gantry = test::gantry;
namespace kr5 = test::kr5;

/// The gantry reaches x <= 0.5 only, with the tilt it is asked for and, as a second branch, with
/// half a turn more.
class GantryIk final : public InverseKinematics {
 public:
  void solve(const Pose& tcp, std::vector<JointVector>& branches) const override {
    branches.clear();
    const Eigen::Vector3d p = tcp.translation();
    if (p.x() > 0.5) return;
    const double tilt = std::atan2(tcp.linear()(2, 1), tcp.linear()(1, 1));
    branches.push_back(gantry::posture(p.x(), p.y(), p.z(), tilt));
    branches.push_back(gantry::posture(p.x(), p.y(), p.z(), tilt > 0 ? tilt - kPi : tilt + kPi));
  }
  std::string description() const override { return "gantry"; }

 private:
  static constexpr double kPi = 3.14159265358979323846;
};

/// y in 5 samples, rx in 5 samples, the rest held.
ToleranceBox sampled_box() {
  ToleranceBox box;
  box.lower << 0, -0.2, 0, -0.4, 0, 0;
  box.upper = -box.lower;
  return box;
}

GraphOptions sampled_options() {
  GraphOptions options;
  options.collision_checks = CollisionChecks::eager;
  options.step << 0, 0.1, 0, 0.2, 0, 0;
  return options;
}

struct Sampling {
  Robot::Parts parts = gantry::parts();
  Task task = gantry::task({{0, 0, 0}, {1, 0, 0}}, 4, 4, sampled_box());
  std::vector<SceneObject> objects;
  double clearance = 0;
  CostOptions cost;
  GraphOptions options = sampled_options();
  Monitor monitor;

  SampledPath run(int threads = 2) const {
    const auto robot = gantry::robot(parts);
    const GantryIk ik;
    const SamplingInput input{*robot, ik, gantry::clearance(robot, objects, clearance), cost,
                              options};
    return sample_path(input, task, threads, monitor);
  }
};

TEST(SamplePath, CountsWhatIsOutOfReachAndWhatBreaksALimit) {
  const SampledPath sampled = Sampling().run();  // tilt within +-3
  ASSERT_EQ(sampled.rungs.size(), 5U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(sampled.counts[i].samples, 25U);
    EXPECT_EQ(sampled.counts[i].out_of_reach, 0U);
    // Tilts -0.4, -0.2, 0, 0.2, 0.4 and, half a turn on, 2.74, 2.94, 3.14, -2.94, -2.74: the third
    // one is beyond the limit.
    const std::map<int, std::size_t> expected = {{3, 5}};
    EXPECT_EQ(sampled.counts[i].joint_limit, expected);
    EXPECT_EQ(sampled.rungs[i].size(), 45);
    for (Eigen::Index v = 0; v < sampled.rungs[i].size(); ++v) {
      const JointVector q = sampled.rungs[i].vertex(v);
      EXPECT_DOUBLE_EQ(q[0], 0.25 * static_cast<double>(i));
      EXPECT_LE(std::abs(q[1]), 0.2 + 1e-12);
      EXPECT_LE(std::abs(q[3]), 3);
    }
  }
  for (std::size_t i = 3; i < 5; ++i) {
    EXPECT_EQ(sampled.counts[i].out_of_reach, 25U);
    EXPECT_EQ(sampled.rungs[i].size(), 0);
  }
}

TEST(SamplePath, SamplesThePartOfTheToleranceThatIsAskedFor) {
  Sampling part;
  part.task.waypoints[1].sampled = sampled_box();
  part.task.waypoints[1].tolerance = sampled_box().widened(0.001, 0.02);
  const SampledPath sampled = part.run();
  EXPECT_EQ(sampled.counts[1].samples, 25U);
  EXPECT_EQ(sampled.counts[2].samples, 25U);
  part.task.waypoints[1].sampled.reset();
  EXPECT_GT(part.run().counts[1].samples, 25U * 81U);  // -, 0 and + of four more coordinates
}

TEST(SamplePath, AddsEveryTurnInsideTheLimits) {
  Sampling sampling;
  sampling.parts.joints[3].lower = -6.5;
  sampling.parts.joints[3].upper = 6.5;
  const auto copies = [](double tilt) {
    int count = 0;
    for (int turn = -3; turn <= 3; ++turn) {
      if (std::abs(tilt + turn * 2 * std::acos(-1.0)) <= 6.5) ++count;
    }
    return count;
  };
  int expected = 0;
  for (const double tilt : {-0.4, -0.2, 0.0, 0.2, 0.4}) {
    expected += 5 * (copies(tilt) + copies(tilt + std::acos(-1.0)));
  }
  EXPECT_GT(expected, 50);
  const auto robot = gantry::robot(sampling.parts);
  EdgeRules rules;
  rules.period = turn_periods(*robot, Turns::all);
  EXPECT_EQ(rules.period[3], 2 * std::acos(-1.0));
  EXPECT_TRUE(std::isinf(rules.period[0]));
  rules.lower = robot->lower_limits();
  rules.upper = robot->upper_limits();
  const SampledPath sampled = sampling.run();
  EXPECT_EQ(sampled.rungs[0].size(), 50);
  EXPECT_EQ(expand_turns(sampled.rungs, rules).rungs[0].size(), expected);
  sampling.options.turns = Turns::principal;
  EXPECT_EQ(sampling.run().rungs[0].size(), 50);
}

/// A wall at y = 0.15: the ball of 0.05 m keeps 0.01 m where y <= 0.09, that is at -0.2, -0.1, 0.
TEST(SamplePath, LeavesOutWhatIsTooNear) {
  Sampling sampling;
  sampling.objects = {gantry::obstacle(Box{{10, 0.1, 10}}, 0, 0.2, 0)};
  sampling.clearance = 0.01;
  const SampledPath sampled = sampling.run();
  EXPECT_EQ(sampled.rungs[0].size(), 27);
  EXPECT_GT(sampled.collision_checks, 0U);
  const std::map<ClearanceModel::Names, std::size_t> expected = {{{"ball", "obstacle"}, 18}};
  EXPECT_EQ(sampled.counts[0].collision, expected);
  for (Eigen::Index v = 0; v < sampled.rungs[0].size(); ++v) {
    EXPECT_LE(sampled.rungs[0].vertex(v)[1], 0.0);
  }
}

/// Eq. 9: w (eta |alpha| + |beta|).
TEST(SamplePath, VerticesCostTheirEulerDeviation) {
  Sampling sampling;
  sampling.cost.euler_graph = 2;
  sampling.cost.euler_eta = 3;
  sampling.options.turns = Turns::principal;
  sampling.task.waypoints[0].tolerance.lower[4] = -0.3;
  sampling.task.waypoints[0].tolerance.upper[4] = 0.3;
  const SampledPath sampled = sampling.run();
  std::map<int, int> found, expected;  // 1000 cost -> vertices
  for (Eigen::Index v = 0; v < sampled.rungs[0].size(); ++v) {
    ++found[static_cast<int>(std::lround(1000 * sampled.rungs[0].cost[v]))];
  }
  for (const double alpha : {-0.4, -0.2, 0.0, 0.2, 0.4}) {
    for (const double beta : {-0.3, 0.0, 0.3}) {
      const int branches = alpha == 0 ? 1 : 2;  // the other one is beyond the limit
      expected[static_cast<int>(std::lround(2000 * (3 * std::abs(alpha) + std::abs(beta))))] +=
          5 * branches;
    }
  }
  EXPECT_EQ(found, expected);
}

TEST(SamplePath, AJointWaypointIsItsPosture) {
  Sampling sampling;
  sampling.cost.euler_graph = 1;
  sampling.task.waypoints[1].joints = gantry::posture(0.3, 0.1, 0, 0.7);
  sampling.task.waypoints[2].joints = gantry::posture(0.3, 0.1, 0, 3.5);
  sampling.task.waypoints[3].joints = gantry::posture(0.3, 1, 0, 0);
  sampling.objects = {gantry::obstacle(Sphere{0.2}, 0.3, 1, 0)};
  const SampledPath sampled = sampling.run();
  ASSERT_EQ(sampled.rungs[1].size(), 1);
  EXPECT_EQ(sampled.rungs[1].vertex(0), gantry::posture(0.3, 0.1, 0, 0.7));
  EXPECT_EQ(sampled.rungs[1].cost[0], 0);
  EXPECT_EQ(sampled.counts[1].samples, 1U);
  EXPECT_EQ(sampled.rungs[2].size(), 0);
  EXPECT_EQ(sampled.counts[2].joint_limit.at(3), 1U);
  EXPECT_EQ(sampled.rungs[3].size(), 0);
  EXPECT_EQ(sampled.counts[3].collision.size(), 1U);
}

/// x at 0.2, 0.3 and 0.4, y at -0.1, 0 and 0.1, tilt at 2.8, 2.9, 3 and, beyond its limit, at 3.1
/// and 3.2. A ball of 0.05 m keeps clear of a ball of 0.07 m at (0.2, 0.1).
TEST(SamplePath, ARangedJointWaypointIsTheGridOfItsRanges) {
  Sampling sampling;
  sampling.options.joint_step = {0.1, 0, 0, 0.1};
  sampling.task.waypoints[1].joints =
      JointBox(gantry::posture(0.2, -0.1, 0, 2.8), gantry::posture(0.4, 0.1, 0, 3.2));
  sampling.objects = {gantry::obstacle(Sphere{0.07}, 0.2, 0.1, 0)};
  const SampledPath sampled = sampling.run();
  std::vector<JointVector> expected;
  for (const double x : {0.2, 0.3, 0.4}) {
    for (const double y : {-0.1, 0.0, 0.1}) {
      if (std::hypot(x - 0.2, y - 0.1) < 0.12) continue;
      for (const double tilt : {2.8, 2.9, 3.0}) expected.push_back(gantry::posture(x, y, 0, tilt));
    }
  }
  const Rung& rung = sampled.rungs[1];
  ASSERT_EQ(static_cast<std::size_t>(rung.size()), expected.size());
  for (std::size_t v = 0; v < expected.size(); ++v) {
    const auto index = static_cast<Eigen::Index>(v);
    EXPECT_LT((rung.vertex(index) - expected[v]).norm(), 1e-14) << v;
    EXPECT_EQ(rung.cost[index], 0);
  }
  // Copies by whole turns are those inside the ranges; the tilt's is cut to its limit.
  EXPECT_EQ(rung.lower, gantry::posture(0.2, -0.1, 0, 2.8));
  EXPECT_EQ(rung.upper, gantry::posture(0.4, 0.1, 0, 3));
  EXPECT_EQ(sampled.counts[1].samples, 3U * 3 * 5);
  EXPECT_EQ(sampled.counts[1].joint_limit.at(3), 3U * 3 * 2);
  EXPECT_EQ(sampled.counts[1].collision.begin()->second, 3U * 3);
}

/// In the base frame the position is sampled along the base axes, whatever the path frame is.
TEST(SamplePath, InTheBaseFrameDeviationsAreAlongTheBase) {
  Sampling sampling;
  Pose turned = Pose::Identity();
  turned.linear() = Eigen::AngleAxisd(0.2, Eigen::Vector3d::UnitX()).toRotationMatrix();
  Waypoint& waypoint = sampling.task.waypoints[0];
  waypoint.frame = turned;
  for (const ToleranceFrame frame : {ToleranceFrame::path, ToleranceFrame::base}) {
    waypoint.tolerance.frame = frame;
    const SampledPath sampled = sampling.run();
    double highest = 0, steepest = 0;
    for (Eigen::Index v = 0; v < sampled.rungs[0].size(); ++v) {
      const JointVector q = sampled.rungs[0].vertex(v);
      highest = std::max(highest, q[2]);
      if (std::abs(q[3]) < 1.5) steepest = std::max(steepest, q[3]);
    }
    EXPECT_NEAR(highest, frame == ToleranceFrame::path ? 0.2 * std::sin(0.2) : 0, 1e-12);
    EXPECT_NEAR(steepest, 0.6, 1e-9);
  }
}

void expect_same(const SampledPath& one, const SampledPath& other) {
  ASSERT_EQ(one.rungs.size(), other.rungs.size());
  for (std::size_t i = 0; i < one.rungs.size(); ++i) {
    ASSERT_EQ(one.rungs[i].size(), other.rungs[i].size());
    EXPECT_TRUE((one.rungs[i].positions == other.rungs[i].positions).all());
    EXPECT_TRUE((one.rungs[i].cost == other.rungs[i].cost).all());
    EXPECT_EQ(one.counts[i].joint_limit, other.counts[i].joint_limit);
    EXPECT_EQ(one.counts[i].collision, other.counts[i].collision);
  }
  EXPECT_EQ(one.collision_checks, other.collision_checks);
}

TEST(SamplePath, DoesNotDependOnTheNumberOfThreads) {
  Sampling sampling;
  sampling.task = gantry::task({{0, 0, 0}, {0.5, 0, 0}}, 4, 30, sampled_box());
  sampling.objects = {gantry::obstacle(Sphere{0.1}, 0.3, 0.1, 0)};
  const SampledPath one = sampling.run(1);
  expect_same(one, sampling.run(3));
  expect_same(one, sampling.run(8));
}

TEST(SamplePath, ReportsItsProgressAndStopsWhenCancelled) {
  Sampling sampling;
  double last = 0;
  sampling.monitor.progress = [&](const std::string& stage, double fraction) {
    EXPECT_EQ(stage, "sampling");
    EXPECT_GE(fraction, last);
    last = fraction;
  };
  sampling.run(1);
  EXPECT_EQ(last, 1);
  const std::atomic<bool> cancel{true};
  sampling.monitor.cancel = &cancel;
  EXPECT_THROW(sampling.run(), Cancelled);
}

/// The KR 5 along 0.5 m with the torch straight down and its spin in steps of 1 deg: the numbers of
/// vertices are known from two independent planners.
TEST(SamplePath, HasTheKnownNumberOfVerticesForTheKr5) {
  const auto robot = kr5::load();
  Task task = gantry::task({{0.9, -0.25, 0.3}, {0.9, 0.25, 0.3}}, 50, 29, ToleranceBox{});
  Pose down = Pose::Identity();
  down.linear() = Eigen::Vector3d(-1, 1, -1).asDiagonal();
  for (Waypoint& waypoint : task.waypoints) {
    waypoint.frame = waypoint.frame * down;
    waypoint.tolerance.lower[5] = -ToleranceBox::kFree;
    waypoint.tolerance.upper[5] = ToleranceBox::kFree;
  }
  Scene scene;
  scene.scope = CollisionScope::off;
  const auto clearance = std::make_shared<const ClearanceModel>(robot, scene);
  const auto ik = find_inverse_kinematics(robot);
  ASSERT_TRUE(ik.solver) << ik.description;
  GraphOptions options;
  options.step[5] = std::acos(-1.0) / 180;
  for (const auto& [turns, expected] :
       {std::pair{Turns::principal, 21600U}, std::pair{Turns::all, 82786U}}) {
    options.turns = turns;
    const CostOptions cost;
    const SampledPath sampled =
        sample_path({*robot, *ik.solver, clearance, cost, options}, task, 2, {});
    EdgeRules rules;
    rules.period = turn_periods(*robot, turns);
    rules.lower = robot->lower_limits();
    rules.upper = robot->upper_limits();
    std::size_t vertices = 0;
    double farthest = 0;
    for (std::size_t i = 0; i < sampled.rungs.size(); ++i) {
      for (Eigen::Index v = 0; v < sampled.rungs[i].size(); ++v) {
        vertices += copy_count(sampled.rungs[i], rules, v);
      }
      for (Eigen::Index v = 0; v < sampled.rungs[i].size(); v += 37) {
        const Eigen::Matrix4d tip = kr5::torch_tip(sampled.rungs[i].vertex(v), 0.3);
        const Pose& frame = task.waypoints[i].frame;
        farthest = std::max({farthest, (tip.topRightCorner<3, 1>() - frame.translation()).norm(),
                             (tip.col(2).head<3>() - frame.linear().col(2)).norm()});
      }
    }
    EXPECT_EQ(vertices, expected);
    EXPECT_LT(farthest, 1e-9);
  }
}

}  // namespace
}  // namespace wristwise
