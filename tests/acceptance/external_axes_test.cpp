// A rail and a positioner, from the problem file to the check. What the torch does on the part is
// measured with two chains of their own, base to tip and base to table, which pass no joint
// backwards.

#include <gtest/gtest.h>

#include <cmath>

#include "temporary_folder.hpp"
#include "wristwise/wristwise.hpp"

namespace wristwise {
namespace {

constexpr double kDegree = 0.017453292519943295;

std::string source_path(const std::string& name) {
  return std::string(WRISTWISE_SOURCE_DIR) + "/" + name;
}

Problem shipped(const std::string& name) {
  return load_problem(source_path("problems/" + name + ".yaml"));
}

void expect_verified(const Problem& problem, const PlanResult& result) {
  ASSERT_EQ(result.status, Status::solved)
      << (result.diagnosis.empty() ? "" : result.diagnosis.front().detail);
  PlanOptions dense;
  dense.verification.samples_per_interval = 50;
  const Verification verification = result.trajectory.empty()
                                        ? check(problem, result.path, dense)
                                        : check(problem, result.trajectory, dense);
  EXPECT_TRUE(verification.passed)
      << (verification.failures.empty() ? "" : verification.failures.front());
  ASSERT_TRUE(verification.clearance.has_value());
  EXPECT_TRUE(verification.clearance_bound.has_value());
}

/// The TCP on the table, and in the hall, by chains that start at the base.
class PositionerOracle {
 public:
  PositionerOracle() : arm_(chain("torch_tip")), table_(chain("table")) {}

  /// @param q turn, tilt, and the arm
  Pose in_hall(const JointVector& q) const { return tcp_pose(arm_, q.tail(6)); }
  Pose on_table(const JointVector& q) const {
    JointVector table(2);
    table << q[1], q[0];
    return tcp_pose(table_, table).inverse() * in_hall(q);
  }

 private:
  static Robot chain(const std::string& tip) {
    RobotSource source;
    source.urdf = source_path("robots/kuka_kr5_arc_positioner/kuka_kr5_arc_positioner.urdf");
    source.tip_link = tip;
    return load_robot(source);
  }
  Robot arm_, table_;
};

class PositionerRing : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    problem_ = new Problem(shipped("positioner_ring"));
    result_ = new PlanResult(plan(*problem_));
  }
  static void TearDownTestSuite() {
    delete result_;
    delete problem_;
  }
  JointVector at(double t, int derivative = 0) const {
    return result_->trajectory.evaluate(t, derivative);
  }

  static Problem* problem_;
  static PlanResult* result_;
  PositionerOracle oracle_;
};

Problem* PositionerRing::problem_ = nullptr;
PlanResult* PositionerRing::result_ = nullptr;

TEST_F(PositionerRing, PassesInBothModes) {
  expect_verified(*problem_, *result_);
  expect_verified(*problem_, plan_graph_only(*problem_));
}

TEST_F(PositionerRing, SeamSpeedAndTorchAngleAreThoseOfTheTable) {
  const double end = problem_->task.seam.end_time();
  const double h = 1e-3;
  for (int k = 0; k <= 400; ++k) {
    const double t = h + (end - 2 * h) * k / 400;
    const Pose tcp = oracle_.on_table(at(t));
    const Eigen::Vector3d p = tcp.translation();
    // A circle of 60 mm about the table's axis, once round; the frame is turned by 90 deg.
    const double angle = -90 * kDegree - 2 * 180 * kDegree * t / end;
    EXPECT_LT((p - 0.06 * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0)).norm(), 2e-4);
    const Eigen::Vector3d ahead = oracle_.on_table(at(t + h)).translation();
    const Eigen::Vector3d behind = oracle_.on_table(at(t - h)).translation();
    EXPECT_NEAR((ahead - behind).norm() / (2 * h), 0.01, 1e-4);
    const Eigen::Vector3d down = tcp.linear().col(2);
    EXPECT_NEAR(std::acos(-down.z()), 45 * kDegree, 0.3 * kDegree);
  }
}

TEST_F(PositionerRing, TheTorchStandsNearlyStillInFlatPosition) {
  const double end = problem_->task.seam.end_time();
  for (int k = 0; k <= 400; ++k) {
    const double t = end * k / 400;
    const JointVector speed = at(t, 1);
    EXPECT_LT(speed.tail(6).cwiseAbs().maxCoeff(), 0.01);
    EXPECT_GT(std::abs(speed[0]), 0.15);
    const Eigen::Vector3d torch = oracle_.in_hall(at(t)).linear().col(2);
    EXPECT_LT(std::acos(-torch.z()), 10 * kDegree);
    const double tilt = at(t)[1];
    EXPECT_TRUE(tilt >= 40 * kDegree - 1e-9 && tilt <= 50 * kDegree + 1e-9);
  }
}

TEST_F(PositionerRing, TheCheckSeesFaultsOfEitherChain) {
  const JointPath& good = result_->path;
  ASSERT_TRUE(check(*problem_, good).passed);
  for (const int joint : {0, 1, 2, 5}) {
    JointPath bad = good;
    for (JointVector& q : bad.positions) q[joint] += 1e-3;
    EXPECT_FALSE(check(*problem_, bad).passed) << joint;
  }
  JointPath backwards = good;
  for (JointVector& q : backwards.positions) q[0] = -q[0];
  EXPECT_FALSE(check(*problem_, backwards).passed);
}

TEST_F(PositionerRing, ThePipeIsWhereTheTableIs) {
  Problem torch_and_pipe = *problem_;
  torch_and_pipe.scene.scope = CollisionScope::pairs;
  torch_and_pipe.scene.pairs = {{"torch", "pipe"}};
  const Verification with_table = check(torch_and_pipe, result_->trajectory);
  ASSERT_TRUE(with_table.passed);
  // 0.06 m of radius, and the tip of the nozzle's shape 18 mm before the corner of the foot.
  EXPECT_LT(*with_table.clearance, 0.018);

  Problem thicker = torch_and_pipe;
  std::get<Cylinder>(thicker.scene.objects[0].shapes[0].geometry).radius += 0.01;
  const Verification too_near = check(thicker, result_->trajectory);
  EXPECT_FALSE(too_near.passed);
  EXPECT_LT(*too_near.clearance, *with_table.clearance - 0.005);

  // Left in the hall, where it stands when the table is level, it is far from the torch or in it.
  Problem forgotten = torch_and_pipe;
  forgotten.scene.objects[0].link = "";
  for (Shape& shape : forgotten.scene.objects[0].shapes)
    shape.pose.pretranslate(Eigen::Vector3d(1.05, 0, 0.857));
  const Verification without_table = check(forgotten, result_->trajectory);
  EXPECT_GT(std::abs(*without_table.clearance - *with_table.clearance), 0.01);
}

// The arm holds the part under a torch that stands still.
TEST(GrippedPart, IsWeldedUnderATorchThatStandsStill) {
  const test::TemporaryFolder folder;
  std::string urdf =
      test::file_text(source_path("robots/kuka_kr5_arc/kuka_kr5_arc_round_torch.urdf"));
  folder.write("cell.urdf", test::replaced(urdf, "</robot>", R"(
  <link name="standing_torch"/>
  <joint name="joint_stand" type="fixed">
    <origin xyz="1.2 0.1 0.8" rpy="0 -1.5707963267948966 0"/>
    <parent link="base_link"/><child link="standing_torch"/>
  </joint>
</robot>
)"));
  const Problem problem =
      load_problem(folder.write("gripped.yaml", R"(
robot: {urdf: cell.urdf, tip_link: standing_torch, limits: )" +
                                                    source_path("robots/kuka_kr5_arc/"
                                                                "joint_limits.yaml") +
                                                    R"(}
scene: {collision: off}
path:
  link: tool0
  speed: 0.01
  waypoints: 21
  segments:
    - line:
        from: {xyz: [0, -0.1, 0.15], rpy: [180 deg, 0, 0]}
        to: {xyz: [0, 0.1, 0.15], rpy: [180 deg, 0, 0]}
  tolerance: {rz: free}
)"));
  EXPECT_EQ(problem.robot->joints().front().name, "joint_a6");
  const PlanResult result = plan(problem);
  ASSERT_EQ(result.status, Status::solved)
      << (result.diagnosis.empty() ? "" : result.diagnosis.front().detail);
  // By the arm's own chain: the seam's point in the hand is at the torch, which points at the
  // robot.
  RobotSource source;
  source.urdf = folder.path() / "cell.urdf";
  source.tip_link = "tool0";
  const Robot arm = load_robot(source);
  for (std::size_t i = 0; i < result.path.size(); ++i) {
    const JointVector q = result.path.positions[i].reverse();
    const double y = -0.1 + 0.2 * static_cast<double>(i) / 20;
    const Pose hand = tcp_pose(arm, q);
    EXPECT_LT((hand * Eigen::Vector3d(0, y, 0.15) - Eigen::Vector3d(1.2, 0.1, 0.8)).norm(), 2e-6);
    EXPECT_LT((hand.linear().col(2) - Eigen::Vector3d::UnitX()).norm(), 2e-6);
  }
}

TEST(RailLongSeam, PassesInBothModesAndNeedsTheRail) {
  Problem problem = shipped("rail_long_seam");
  const PlanResult two_stage = plan(problem);
  expect_verified(problem, two_stage);
  expect_verified(problem, plan_graph_only(problem));
  double least = HUGE_VAL, largest = -HUGE_VAL;
  for (const JointVector& q : two_stage.path.positions) {
    least = std::min(least, q[0]);
    largest = std::max(largest, q[0]);
  }
  EXPECT_GT(largest - least, 0.5);

  problem.graph.try_relaxations = false;
  problem.graph.redundancy.clear();
  Robot::Parts parts = problem.robot->parts();
  parts.joints[0].lower = parts.joints[0].upper = 0;  // in the middle of the seam
  problem.robot = std::make_shared<const Robot>(parts);
  EXPECT_EQ(plan_graph_only(problem).status, Status::infeasible);
}

}  // namespace
}  // namespace wristwise
