// The problems of the offset-wrist arm and of the seven-axis arm, followed by the makers' own
// kinematics. That they are solved and pass the check is for shipped_problems_test.cpp to say.

#include <gtest/gtest.h>

#include <cmath>

#include "published_arms.hpp"
#include "wristwise/wristwise.hpp"

namespace wristwise {
namespace {

constexpr double kDegree = 0.017453292519943295;

Problem shipped(const std::string& name) {
  return load_problem(std::string(WRISTWISE_SOURCE_DIR) + "/problems/" + name + ".yaml");
}

/// The torch by the published kinematics: position of the TCP and direction of the wire.
struct Torch {
  Torch(const test::PublishedArm& arm, const JointVector& q) {
    const Eigen::Matrix4d tip =
        arm.flange(q) * test::kr5::turn(1, 45 * kDegree) * test::kr5::shift({0, 0, 0.38});
    tcp = tip.topRightCorner<3, 1>();
    wire = tip.block<3, 1>(0, 2);
  }
  Eigen::Vector3d tcp, wire;
};

/// Angles of the wire against the bisector of the corner, in a frame with z along the bisector and
/// y along the weld: R = Rx(travel) Ry(work) Rz(spin) has the third column
/// (sin work, -sin travel cos work, cos travel cos work).
void expect_angles(const Torch& torch, const Eigen::Vector3d& bisector,
                   const Eigen::Vector3d& along, double work, double least_travel,
                   double most_travel) {
  const Eigen::Vector3d x = along.cross(bisector);
  const double travel = std::atan2(-torch.wire.dot(along), torch.wire.dot(bisector));
  EXPECT_LE(std::abs(std::asin(torch.wire.dot(x))), work + 2e-6);
  EXPECT_GE(travel, least_travel - 2e-6);
  EXPECT_LE(travel, most_travel + 2e-6);
}

class InBothModes : public testing::TestWithParam<bool> {
 protected:
  static PlanResult planned(const Problem& problem) {
    return GetParam() ? plan(problem) : plan_graph_only(problem);
  }
};

TEST_P(InBothModes, TheOffsetWristArmGoesAllTheWayAroundThePipe) {
  const Problem problem = shipped("offset_wrist_pipe_ring");
  const PlanResult result = planned(problem);
  ASSERT_EQ(result.status, Status::solved);
  const std::size_t count = result.path.size();
  ASSERT_EQ(count, 73U);
  for (std::size_t i = 0; i < count; ++i) {
    const Torch torch(test::offset_wrist_arm(), result.path.positions[i]);
    const double angle = 360 * kDegree * double(i) / double(count - 1);  // clockwise from -x
    const Eigen::Vector3d outwards(-std::cos(angle), std::sin(angle), 0), z(0, 0, 1);
    const Eigen::Vector3d nominal = Eigen::Vector3d(0.8, 0, 0.085) + 0.05715 * outwards;
    EXPECT_LT((torch.tcp - nominal).norm(), 2e-6) << i;
    expect_angles(torch, (-outwards - z).normalized(), outwards.cross(z), 5 * kDegree,
                  -10 * kDegree, 5 * kDegree);
  }
}

TEST_P(InBothModes, TheSevenAxisArmFollowsTheJoint) {
  const Problem problem = shipped("seven_axis_t_joint");
  const PlanResult result = planned(problem);
  ASSERT_EQ(result.status, Status::solved);
  const std::size_t count = result.path.size();
  const Eigen::Vector3d bisector = Eigen::Vector3d(1, 0, -1).normalized(), y(0, 1, 0);
  for (std::size_t i = 0; i < count; ++i) {
    const Torch torch(test::seven_axis_arm(), result.path.positions[i]);
    const Eigen::Vector3d nominal(0.8, -0.17 + 0.33 * double(i) / double(count - 1), 0.11);
    const Eigen::Vector3d off = torch.tcp - nominal;
    EXPECT_LE(std::abs(off.dot(bisector)), 1.5e-3 + 2e-6) << i;  // stick-out
    EXPECT_LT((off - off.dot(bisector) * bisector).norm(), 2e-6) << i;
    expect_angles(torch, bisector, y, 5 * kDegree, -15 * kDegree, 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Modes, InBothModes, testing::Bool(), [](const auto& two_stage) {
  return two_stage.param ? "TwoStage" : "GraphOnly";
});

/// A coordinate of the tolerance closed on a piece of the seam, in the problem and so in its grid.
std::string reason_without(int coordinate, std::ptrdiff_t first, std::ptrdiff_t last) {
  Problem problem = shipped("seven_axis_t_joint");
  problem.graph.try_relaxations = false;
  const std::vector<Waypoint> whole = problem.task.waypoints;
  problem.task.waypoints.assign(whole.begin() + first, whole.begin() + last + 1);
  for (Waypoint& waypoint : problem.task.waypoints)
    waypoint.tolerance.lower[coordinate] = waypoint.tolerance.upper[coordinate] = 0;
  const PlanResult result = plan_graph_only(problem);
  EXPECT_EQ(result.status, Status::infeasible);
  return result.diagnosis.empty() ? "" : result.diagnosis.front().detail;
}

TEST(SevenAxisTJoint, NeedsItsWorkAngleUnderTheClampAndItsTravelAngleAtTheGusset) {
  EXPECT_NE(reason_without(4, 20, 24).find("torch - clamp"), std::string::npos);
  EXPECT_NE(reason_without(3, 40, 42).find("torch - gusset"), std::string::npos);
}

/// Joint 3 is sampled in stage 1 only: stage 2 moves it with the others.
TEST(SevenAxisTJoint, MovesAllItsJoints) {
  const PlanResult result = plan(shipped("seven_axis_t_joint"));
  ASSERT_EQ(result.status, Status::solved);
  for (int joint = 0; joint < 7; ++joint) {
    double least = 1e9, most = -1e9;
    for (const JointVector& q : result.path.positions) {
      least = std::min(least, q[joint]);
      most = std::max(most, q[joint]);
    }
    EXPECT_GT(most - least, 1e-3) << joint;
  }
}

}  // namespace
}  // namespace wristwise
