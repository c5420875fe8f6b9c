// One seam with every kind of waypoint, in both modes: joint waypoints with ranges and without,
// boxes in the path frame and in the base frame, a tool that is free about one of its axes.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "kuka_kr5_arc.hpp"
#include "temporary_folder.hpp"
#include "wristwise/wristwise.hpp"

namespace wristwise {
namespace {

namespace kr5 = test::kr5;

constexpr double kDegree = 3.14159265358979323846 / 180;
constexpr double kSpeed = 0.04;    // m/s
constexpr double kTorch = 0.3;     // m
constexpr double kStartY = -0.15;  // m; the three lines run along y to 0.15
constexpr double kRounding = 2e-12;

// Waypoints: 0 ranged, 1 to 6 first line, 7 to 11 second, 12 to 16 third, 17 exact, 18 ranged.
constexpr std::size_t kFirstLine = 1, kSecondLine = 7, kThirdLine = 12, kExact = 17, kEnd = 18;

struct Range {
  double lower, upper;
};
using Ranges = std::array<Range, 6>;

constexpr Ranges kStartPosture = {{{0.2, 0.5},
                                   {-1.4555, -1.4555},
                                   {2.21735, 2.21735},
                                   {-1.5, -1.1},
                                   {0.2339, 0.2339},
                                   {1.2, 1.9}}};
constexpr Ranges kExactPosture = {
    {{-0.3, -0.3}, {-1.5, -1.5}, {2.1, 2.1}, {1.3, 1.3}, {0.3, 0.3}, {-1.5, -1.5}}};
constexpr Ranges kEndPosture = {
    {{-0.4, -0.4}, {-1.7, -1.4}, {2, 2}, {1.3, 1.3}, {0.3, 0.6}, {-2, -1}}};

std::string pose_text(double y, const std::string& rpy) {
  return "{xyz: [0.82, " + std::to_string(y) + ", 0.27], rpy: " + rpy + "}";
}

std::string line_text(double y, const std::string& rpy, const std::string& tolerance) {
  return "    - line: {from: " + pose_text(y, rpy) + ", to: " + pose_text(y + 0.1, rpy) +
         "}\n      tolerance: {" + tolerance + "}\n";
}

struct Symmetry {
  int axis;
  std::string rpy;     ///< of the third line: the torch straight down, turned about the axis
  std::string others;  ///< tolerances of the two angles that are not free
};

void PrintTo(const Symmetry& symmetry, std::ostream* out) { *out << "xyz"[symmetry.axis]; }

std::string problem_text(const Symmetry& symmetry) {
  const std::string robots = std::string(WRISTWISE_SOURCE_DIR) + "/robots/kuka_kr5_arc/";
  const std::string down = "[0, 180 deg, 0]";
  return "robot:\n  urdf: " + robots +
         "kuka_kr5_arc_round_torch.urdf\n  base_link: base_link\n  tip_link: torch_tip\n  "
         "limits: " +
         robots +
         "joint_limits.yaml\n"
         "scene:\n  clearance: 5 mm\n"
         "  objects: [{name: plate, box: [0.6, 0.9, 0.02], xyz: [0.82, 0, 0.2]}]\n"
         "path:\n  speed: 0.04\n  spacing: 0.02\n  segments:\n"
         "    - joints: [[[0.2, 0.5], -1.4555, 2.21735, [-1.5, -1.1], 0.2339, [1.2, 1.9]]]\n" +
         line_text(-0.15, down,
                   "x: 1 mm, z: [-2 mm, 1 mm], rx: 5 deg, ry: [-3 deg, 5 deg], rz: 20 deg") +
         line_text(-0.05, down, "frame: base, x: [0, 2 mm], rx: 10 deg, rz: [-10 deg, 20 deg]") +
         line_text(
             0.05, symmetry.rpy,
             std::string("axially_symmetric: ") + "xyz"[symmetry.axis] + ", " + symmetry.others) +
         "    - joints: [[-0.3, -1.5, 2.1, 1.3, 0.3, -1.5],\n"
         "               [-0.4, [-1.7, -1.4], 2, 1.3, [0.3, 0.6], [-2, -1]]]\n"
         "graph: {samples: {rx: 5 deg, ry: 5 deg, rz: 10 deg, joints: 10 deg}}\n";
}

/// The torch straight down: half a turn about y.
Eigen::Matrix3d torch_down() { return Eigen::Vector3d(-1, 1, -1).asDiagonal(); }

/// Angles of R = Rx(a) Ry(b) Rz(c), read off its entries.
Eigen::Vector3d angles_xyz(const Eigen::Matrix3d& r) {
  return {std::atan2(-r(1, 2), r(2, 2)), std::asin(r(0, 2)), std::atan2(-r(0, 1), r(0, 0))};
}

double wrapped(double angle) { return std::remainder(angle, 360 * kDegree); }

void expect_inside(double value, const Range& range, double slack, const std::string& what) {
  EXPECT_GE(value, range.lower - slack) << what;
  EXPECT_LE(value, range.upper + slack) << what;
}

class MixedWaypoints : public testing::TestWithParam<Symmetry> {
 protected:
  MixedWaypoints()
      : problem_(load_problem(folder_.write("mixed.yaml", problem_text(GetParam())))) {}

  /// Nothing of the library below: the tests' own chain of the robot.
  struct Tip {
    Eigen::Vector3d off;  ///< from the nominal TCP, m, base frame
    Eigen::Matrix3d rotation;
  };
  static Tip tip(const JointVector& q, double y) {
    const Eigen::Matrix4d pose = kr5::torch_tip(q, kTorch);
    return {pose.topRightCorner<3, 1>() - Eigen::Vector3d(0.82, y, 0.27),
            pose.topLeftCorner<3, 3>()};
  }

  static void expect_first_line(const Tip& tip, double position, double angle) {
    const Eigen::Vector3d off = torch_down().transpose() * tip.off;
    expect_inside(off.x(), {-0.001, 0.001}, position, "first x");
    expect_inside(off.y(), {0, 0}, position, "first y");
    expect_inside(off.z(), {-0.002, 0.001}, position, "first z");
    const Eigen::Vector3d e = angles_xyz(torch_down().transpose() * tip.rotation);
    expect_inside(e.x(), {-5 * kDegree, 5 * kDegree}, angle, "first rx");
    expect_inside(e.y(), {-3 * kDegree, 5 * kDegree}, angle, "first ry");
    expect_inside(e.z(), {-20 * kDegree, 20 * kDegree}, angle, "first rz");
  }

  /// Half a turn about y is also one about x and then one about z: (180 deg, 0, 180 deg).
  static void expect_second_line(const Tip& tip, double position, double angle) {
    expect_inside(tip.off.x(), {0, 0.002}, position, "second x");
    expect_inside(tip.off.y(), {0, 0}, position, "second y");
    expect_inside(tip.off.z(), {0, 0}, position, "second z");
    const Eigen::Vector3d e = angles_xyz(tip.rotation);
    expect_inside(wrapped(e.x() - 180 * kDegree), {-10 * kDegree, 10 * kDegree}, angle,
                  "second rx");
    expect_inside(e.y(), {0, 0}, angle, "second ry");
    expect_inside(wrapped(e.z() - 180 * kDegree), {-10 * kDegree, 20 * kDegree}, angle,
                  "second rz");
  }

  /// The direction of the free axis, in the nominal frame, shows the two angles that count. With
  /// i the free axis and j, k the next ones: R = Rj(b) Rk(c) Ri gives it the entries
  /// (cos b cos c, sin c, -sin b cos c) along i, j, k.
  static void expect_third_line(const Tip& tip, double position, double angle) {
    EXPECT_LE(tip.off.cwiseAbs().maxCoeff(), position);
    const int i = GetParam().axis, j = (i + 1) % 3, k = (i + 2) % 3;
    const Eigen::Matrix3d nominal =
        torch_down() * Eigen::AngleAxisd(100 * kDegree, Eigen::Vector3d::Unit(i));
    const Eigen::Matrix3d turn = nominal.transpose() * tip.rotation;
    const Eigen::Vector3d free = turn.col(i);
    const double limit = 5 * kDegree + angle;
    EXPECT_LE(std::abs(std::atan2(-free[k], free[i])), limit);
    EXPECT_LE(std::abs(std::asin(free[j])), limit);
    EXPECT_GT(Eigen::AngleAxisd(turn).angle(), 30 * kDegree) << "the freedom is not used";
  }

  static void expect_posture(const JointVector& q, const Ranges& ranges) {
    for (Eigen::Index j = 0; j < 6; ++j) {
      const Range& range = ranges[static_cast<std::size_t>(j)];
      const double slack = range.lower == range.upper ? 1e-6 : 1e-9;
      expect_inside(q[j], range, slack, "joint " + std::to_string(j + 1));
    }
  }

  static void expect_waypoints(const JointPath& path) {
    ASSERT_EQ(path.size(), kEnd + 1);
    expect_posture(path.positions[0], kStartPosture);
    expect_posture(path.positions[kExact], kExactPosture);
    expect_posture(path.positions[kEnd], kEndPosture);
    for (std::size_t i = kFirstLine; i < kExact; ++i) {
      const double y = kStartY + 0.02 * static_cast<double>(i - kFirstLine);
      expect_line(i, tip(path.positions[i], y), 1e-6, 1e-6);
    }
  }

  static void expect_line(std::size_t waypoint, const Tip& tip, double position, double angle) {
    if (waypoint < kSecondLine) return expect_first_line(tip, position, angle);
    if (waypoint < kThirdLine) return expect_second_line(tip, position, angle);
    expect_third_line(tip, position, angle);
  }

  /// The moves take the time of the straight way of the TCP between the nominal postures.
  static void expect_times(const std::vector<double>& times) {
    JointVector middle(6);
    for (Eigen::Index j = 0; j < 6; ++j) {
      const Range& range = kStartPosture[static_cast<std::size_t>(j)];
      middle[j] = (range.lower + range.upper) / 2;
    }
    EXPECT_NEAR(times[1], tip(middle, kStartY).off.norm() / kSpeed, kRounding);
    EXPECT_NEAR(times[kExact - 1] - times[1], 0.3 / kSpeed, kRounding);
  }

  test::TemporaryFolder folder_;
  const Problem problem_;
};

TEST_P(MixedWaypoints, GraphOnly) {
  const PlanResult result = plan_graph_only(problem_);
  ASSERT_EQ(result.status, Status::solved)
      << (result.diagnosis.empty() ? "" : result.diagnosis.front().detail);
  expect_waypoints(result.path);
  expect_times(result.path.times);
}

TEST_P(MixedWaypoints, TwoStage) {
  const PlanResult result = plan(problem_);
  ASSERT_EQ(result.status, Status::solved)
      << (result.diagnosis.empty() ? "" : result.diagnosis.front().detail);
  expect_waypoints(result.path);
  const double t0 = result.path.times[1];
  for (double t = t0; t <= result.path.times[kExact - 1]; t += 0.01) {
    const auto next = std::lower_bound(result.path.times.begin() + 2, result.path.times.end(), t);
    const auto waypoint = static_cast<std::size_t>(next - result.path.times.begin());
    const Tip at = tip(result.trajectory.evaluate(t), kStartY + kSpeed * (t - t0));
    expect_line(waypoint, at, 1e-4 + 1e-6, 0.1 * kDegree + 1e-6);
  }
}

/// The file that is written passes the check that reads it, and the ranges count there.
TEST_P(MixedWaypoints, AFileOfTheResultIsChecked) {
  const PlanResult result = plan_graph_only(problem_);
  const std::vector<std::string> names = problem_.robot->joint_names();
  const auto checked = [&](const JointPath& path) {
    const auto file = folder_.path() / "path.csv";
    write_path(file, names, path);
    return check(problem_, read_trajectory(file, names).path);
  };
  EXPECT_TRUE(checked(result.path).passed);
  JointPath path = result.path;
  path.positions[kEnd][4] = 0.6 + 1e-6;
  const Verification verification = checked(path);
  ASSERT_EQ(verification.failures.size(), 1U);
  EXPECT_NE(verification.failures[0].find("joint_a5 is 1e-06 outside its range [0.3, 0.6]"),
            std::string::npos)
      << verification.failures[0];
}

INSTANTIATE_TEST_SUITE_P(
    Axes, MixedWaypoints,
    testing::Values(Symmetry{0, "[100 deg, 180 deg, 0]", "ry: 5 deg, rz: 5 deg"},
                    Symmetry{1, "[0, 280 deg, 0]", "rx: 5 deg, rz: 5 deg"},
                    Symmetry{2, "[0, 180 deg, -100 deg]", "rx: 5 deg, ry: 5 deg"}));

}  // namespace
}  // namespace wristwise
