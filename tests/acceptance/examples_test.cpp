// The examples of docs/examples, run as a reader runs them. What they print and write is held
// against forward kinematics, sums and distances that are written out here.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <sstream>

#include "convex_points.hpp"
#include "csv_columns.hpp"
#include "kuka_kr5_arc.hpp"
#include "run_example.hpp"

namespace wristwise {
namespace {

using test::CsvColumns;
using test::ProgramRun;
using test::run_example;
using test::shipped;
using test::TemporaryFolder;
using Tcp = std::function<Eigen::Matrix4d(const Eigen::VectorXd&)>;

constexpr double kDegree = 0.017453292519943295;
constexpr double kTorch = 0.3;  // m, of the round torch

/// The number that follows `label` in a text.
double number_after(const std::string& text, const std::string& label) {
  const std::size_t at = text.find(label);
  EXPECT_NE(at, std::string::npos) << "'" << label << "' in\n" << text;
  if (at == std::string::npos) return std::nan("");
  return std::stod(text.substr(at + label.size()));
}

const std::vector<std::string> kPlanarJoints = {"joint_1", "joint_2", "joint_3"};
const std::vector<std::string> kKr5Joints = {"joint_a1", "joint_a2", "joint_a3",
                                             "joint_a4", "joint_a5", "joint_a6"};

/// x, y and heading of problems/planar_3r.yaml's arm.
Eigen::Vector3d planar_tcp(const Eigen::VectorXd& q) {
  const double a = q[0], b = a + q[1], c = b + q[2];
  return {0.5 * std::cos(a) + 0.4 * std::cos(b) + 0.2 * std::cos(c),
          0.5 * std::sin(a) + 0.4 * std::sin(b) + 0.2 * std::sin(c), c};
}

/// On the line of problems/planar_3r.yaml, inside its tolerance, at waypoint i of 40.
void expect_on_planar_line(const Eigen::VectorXd& q, std::size_t i) {
  const Eigen::Vector3d tcp = planar_tcp(q);
  EXPECT_LE(std::abs(tcp.x() - 0.7), 0.03 + 2e-6) << i;
  EXPECT_NEAR(tcp.y(), -0.4 + 0.8 * static_cast<double>(i) / 39, 2e-6) << i;
  EXPECT_LE(std::abs(tcp.z()), 40 * kDegree + 2e-6) << i;
}

double sum_of_steps(const std::vector<Eigen::VectorXd>& path) {
  double sum = 0;
  for (std::size_t i = 1; i < path.size(); ++i) sum += (path[i] - path[i - 1]).lpNorm<1>();
  return sum;
}

TEST(Examples, PlanASeam) {
  const TemporaryFolder folder;
  const ProgramRun ran =
      run_example("01_plan_a_seam", folder, {shipped("problems/planar_3r.yaml"), "out.csv"});
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_EQ(number_after("\n" + ran.out, "\n"), 40);
  const CsvColumns file(folder.path() / "out.csv");
  const auto path = file.rows(kPlanarJoints);
  ASSERT_EQ(path.size(), 40U);
  for (std::size_t i = 0; i < path.size(); ++i) expect_on_planar_line(path[i], i);
}

/// What there is no way for is told in words, with a suggestion.
TEST(Examples, PlanASeamThatIsOutOfReach) {
  const TemporaryFolder folder;
  std::string text = test::file_text(shipped("problems/planar_3r.yaml"));
  for (const char* y : {"-0.4", "0.4"})
    text = test::replaced(text, "[0.7, " + std::string(y), "[1.7, " + std::string(y));
  text = test::replaced(text, "robots/planar_3r/planar_3r.urdf", "planar.urdf");
  text = test::replaced(text, "../planar.urdf", shipped("robots/planar_3r/planar_3r.urdf"));
  text = test::replaced(text, "../robots", shipped("robots"));
  folder.write("far.yaml", text);
  const ProgramRun ran = run_example("01_plan_a_seam", folder, {"far.yaml", "out.csv"});
  EXPECT_EQ(ran.exit_code, 1) << ran.err;
  EXPECT_NE(ran.out.find("reach"), std::string::npos) << ran.out;
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "out.csv"));
}

/// Known answer 1: the least cost, found by a plain Dijkstra elsewhere.
TEST(Examples, GraphOnly) {
  const TemporaryFolder folder;
  const ProgramRun ran =
      run_example("02_graph_only", folder, {shipped("problems/known_graph.yaml"), "path.csv"});
  EXPECT_EQ(ran.exit_code, 0) << ran.err << ran.out;
  const double cost = number_after(ran.out, "cost ");
  EXPECT_NEAR(cost, 0.858493816637, 1e-6);
  EXPECT_EQ(number_after(ran.out.substr(ran.out.find('\n')), "\n"), 82786);
  const auto path = CsvColumns(folder.path() / "path.csv").rows(kKr5Joints);
  EXPECT_NEAR(sum_of_steps(path), cost, 1e-6);
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Eigen::Matrix4d tcp = test::kr5::torch_tip(path[i], kTorch);
    const Eigen::Vector3d seam(0.9, -0.25 + 0.5 * static_cast<double>(i) / 29, 0.3);
    const Eigen::Vector3d position = tcp.topRightCorner<3, 1>(), along = tcp.block<3, 1>(0, 2);
    EXPECT_LT((position - seam).norm(), 1e-6);
    EXPECT_LT((along + Eigen::Vector3d::UnitZ()).norm(), 1e-6);  // straight down
  }
}

double peak_jerk(const CsvColumns& file, const std::string& joint) {
  const auto t = file.column("time"), q = file.column(joint);
  double peak = 0;
  for (std::size_t i = 0; i + 3 < t.size(); ++i) {
    double sum = 0;  // 3! times Newton's third divided difference
    for (std::size_t a = i; a < i + 4; ++a) {
      double product = 1;
      for (std::size_t b = i; b < i + 4; ++b)
        if (a != b) product *= t[a] - t[b];
      sum += q[a] / product;
    }
    peak = std::max(peak, std::abs(6 * sum));
  }
  return peak;
}

/// Where straight moves between the rows are at time t.
Eigen::VectorXd interpolated(const std::vector<double>& times,
                             const std::vector<Eigen::VectorXd>& rows, double t) {
  const auto after = std::upper_bound(times.begin() + 1, times.end() - 1, t);
  const auto i = static_cast<std::size_t>(after - times.begin());
  const double share = (t - times[i - 1]) / (times[i] - times[i - 1]);
  return rows[i - 1] + share * (rows[i] - rows[i - 1]);
}

TEST(Examples, SmoothAPath) {
  const TemporaryFolder folder;
  const std::string robot = shipped("robots/kuka_kr5_arc/");
  const ProgramRun ran =
      run_example("03_smooth_a_path", folder,
                  {robot + "kuka_kr5_arc_round_torch.urdf", robot + "joint_limits.yaml",
                   shipped("problems/recorded_path.csv"), "smooth.csv"});
  EXPECT_EQ(ran.exit_code, 0) << ran.err << ran.out;
  const CsvColumns before(shipped("problems/recorded_path.csv")),
      after(folder.path() / "smooth.csv");
  const auto given = before.rows(kKr5Joints), smooth = after.rows(kKr5Joints);
  const auto given_times = before.column("time"), times = after.column("time");
  ASSERT_GE(times.size(), given_times.size());
  ASSERT_EQ(times.front(), given_times.front());
  ASSERT_EQ(times.back(), given_times.back());
  for (std::size_t i = 0; i < times.size(); ++i) {
    const Eigen::VectorXd there = interpolated(given_times, given, times[i]);
    const Eigen::Matrix4d a = test::kr5::torch_tip(there, kTorch),
                          b = test::kr5::torch_tip(smooth[i], kTorch);
    const double away = (a - b).topRightCorner<3, 1>().norm();
    EXPECT_LE(away, 0.5e-3 + 2e-6) << i;
    const double trace = (a.topLeftCorner<3, 3>().transpose() * b.topLeftCorner<3, 3>()).trace();
    EXPECT_LE(std::acos(std::min(1.0, (trace - 1) / 2)), 0.5 * kDegree + 2e-6) << i;
  }
  for (const std::string& joint : kKr5Joints) {
    const double rough = peak_jerk(before, joint), ironed = peak_jerk(after, joint);
    EXPECT_LT(ironed, 0.1 * rough) << joint;
    EXPECT_NEAR(number_after(ran.out, joint), rough, 1e-4 * rough) << joint;
    EXPECT_NEAR(number_after(ran.out.substr(ran.out.find(joint)), "-> "), ironed, 1e-4 * ironed);
  }
}

/// Of problems/slide_along_plate.yaml, whose torch is upright: the turn about its axis at q.
double spin(const Eigen::VectorXd& q) {
  // The frame of the seam is turned by 180 deg about y; R = Rx Ry Rz.
  const Eigen::Matrix3d frame = Eigen::Vector3d(-1, 1, -1).asDiagonal();
  const Eigen::Matrix3d r =
      frame.transpose() * test::kr5::torch_tip(q, kTorch).topLeftCorner<3, 3>();
  return std::atan2(-r(0, 1), r(0, 0));
}

double chord(double angle) { return 2 * std::sin(angle / 2); }

TEST(Examples, OwnCost) {
  const TemporaryFolder folder;
  const ProgramRun ran =
      run_example("04_own_cost", folder, {shipped("problems/slide_along_plate.yaml"), "."});
  EXPECT_EQ(ran.exit_code, 0) << ran.err << ran.out;

  const auto seed = CsvColumns(folder.path() / "stage_1.csv").rows(kKr5Joints);
  double own = 0;
  for (const Eigen::VectorXd& q : seed) own += 0.02 * std::abs(chord(spin(q)));
  EXPECT_GT(own, 0);
  const double cost = number_after(ran.out, "cost of stage 1: ");
  EXPECT_NEAR(sum_of_steps(seed) + own, cost, 1e-5 * cost);

  const CsvColumns curve(folder.path() / "stage_2.csv");
  const auto path = curve.rows(kKr5Joints);
  double mean = 0;
  for (const Eigen::VectorXd& q : path) mean += std::abs(spin(q)) / kDegree;
  mean /= static_cast<double>(path.size());
  const double without = number_after(ran.out, "mean spin without ");
  const double with = number_after(ran.out, "with ");
  EXPECT_NEAR(number_after(ran.out, "deg, with "), mean, 1e-4 * mean);
  EXPECT_LT(mean, 0.5 * without) << with;

  // The integral by the trapezoid rule over the rows: half a second apart or less, and smooth.
  const auto t = curve.column("time");
  double integral = 0;
  for (std::size_t i = 1; i < t.size(); ++i) {
    const double a = 0.2 * chord(spin(path[i - 1])), b = 0.2 * chord(spin(path[i]));
    integral += (t[i] - t[i - 1]) * (a * a + b * b) / 2;
  }
  EXPECT_NEAR(number_after(ran.out, "own term of stage 2: "), integral, 0.01 * integral);
}

TEST(Examples, OwnIk) {
  const TemporaryFolder folder;
  const ProgramRun ran = run_example(
      "05_own_ik", folder, {shipped("problems/planar_3r.yaml"), "built_in.csv", "own.csv"});
  EXPECT_EQ(ran.exit_code, 0) << ran.err << ran.out;
  EXPECT_NE(ran.out.find("closed form of a planar arm: cost"), std::string::npos) << ran.out;
  const auto built_in = CsvColumns(folder.path() / "built_in.csv").rows(kPlanarJoints);
  const auto own = CsvColumns(folder.path() / "own.csv").rows(kPlanarJoints);
  ASSERT_EQ(own.size(), 40U);
  ASSERT_EQ(built_in.size(), 40U);
  for (std::size_t i = 0; i < own.size(); ++i) {
    expect_on_planar_line(own[i], i);
    EXPECT_LT((own[i] - built_in[i]).norm(), 1e-6) << i;
  }
  // cost.position: 20 rad per m of |x|.
  double away = 0;
  for (const Eigen::VectorXd& q : own) away += std::abs(planar_tcp(q).x() - 0.7);
  const double cost = number_after(ran.out, "arm: cost ");
  EXPECT_NEAR(sum_of_steps(own) + 20 * away, cost, 1e-6);
}

TEST(Examples, OwnIkIsForItsRobot) {
  const TemporaryFolder folder;
  const ProgramRun ran =
      run_example("05_own_ik", folder, {shipped("problems/known_graph.yaml"), "a.csv", "b.csv"});
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_NE(ran.err.find("three joints"), std::string::npos) << ran.err;
}

/// Distance (m) of the torch, a capsule of 20 mm about the line from tool0 to the tip, at q.
double torch_distance(const Eigen::VectorXd& q, const test::ConvexBody& body) {
  const Eigen::Vector3d start = test::kr5::tool0(q).topRightCorner<3, 1>();
  const Eigen::Vector3d tip = test::kr5::torch_tip(q, kTorch).topRightCorner<3, 1>();
  return test::distance_to_segment(body, start, tip) - 0.02;
}

TEST(Examples, OwnScene) {
  const TemporaryFolder folder;
  const std::string robot = shipped("robots/kuka_kr5_arc/");
  const ProgramRun ran =
      run_example("06_own_scene", folder,
                  {robot + "kuka_kr5_arc_round_torch.urdf", robot + "joint_limits.yaml",
                   shipped("problems/l_profile.stl"), "out.csv"});
  ASSERT_EQ(ran.exit_code, 0) << ran.err << ran.out;
  const auto path = CsvColumns(folder.path() / "out.csv").rows(kKr5Joints);
  ASSERT_EQ(path.size(), 40U);
  // The profile: two legs of 150 x 10 mm, 400 mm long, turned by 180 deg about z.
  const std::map<std::string, std::vector<test::ConvexBody>> objects = {
      {"plate", {test::box_body({0.82, 0, 0.265}, {0.3, 0.4, 0.01})}},
      {"post", {test::upright_cylinder({0.862, 0.05, 0.37}, 0.02, 0.2)}},
      {"gusset", {test::prism_body({0.71, -0.1, 0.27}, 0.07, 0.08, 0.01)}},
      {"profile",
       {test::box_body({0.995, 0, 0.275}, {0.15, 0.4, 0.01}),
        test::box_body({0.915, 0, 0.345}, {0.01, 0.4, 0.15})}}};
  double least = 1;
  for (const auto& [name, bodies] : objects) {
    double distance = 1;
    for (const Eigen::VectorXd& q : path)
      for (const test::ConvexBody& body : bodies)
        distance = std::min(distance, torch_distance(q, body));
    EXPECT_NE(ran.out.find("mm from torch", ran.out.find(name)), std::string::npos) << ran.out;
    EXPECT_NEAR(number_after(ran.out, name + ": "), 1000 * distance, 2e-3) << name;
    least = std::min(least, distance);
  }
  EXPECT_GE(least, 0.004 - 1e-6);
  const double of_all_t = number_after(ran.out, "least clearance of all t: ");
  EXPECT_LE(of_all_t, 1000 * least + 2e-3);
  EXPECT_GE(of_all_t, 4 - 0.051);
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Eigen::Matrix4d tip = test::kr5::torch_tip(path[i], kTorch + 0.025);
    const Eigen::Vector3d seam(0.82, -0.15 + 0.3 * static_cast<double>(i) / 39, 0.27);
    const Eigen::Vector3d position = tip.topRightCorner<3, 1>();
    EXPECT_LT((position - seam).norm(), 2e-6) << i;
  }
}

/// A row of a table of numbers, one cell changed by `shift`.
std::string with_fault(const std::string& csv, std::size_t row, double shift) {
  std::istringstream lines(csv);
  std::string result, line;
  for (std::size_t i = 0; std::getline(lines, line); ++i) {
    if (i == row) {
      const std::size_t first = line.find(',') + 1, second = line.find(',', first);
      const double value = std::stod(line.substr(first, second - first)) + shift;
      line.replace(first, second - first, std::to_string(value));
    }
    result += line + "\n";
  }
  return result;
}

TEST(Examples, CheckAFile) {
  const TemporaryFolder folder;
  const std::string problem = shipped("problems/planar_3r.yaml");
  ASSERT_EQ(run_example("01_plan_a_seam", folder, {problem, "good.csv"}).exit_code, 0);
  const ProgramRun good = run_example("07_check_a_file", folder, {problem, "good.csv"});
  EXPECT_EQ(good.exit_code, 0) << good.out;
  EXPECT_NE(good.out.find("a curve of 40 points"), std::string::npos) << good.out;
  EXPECT_NE(good.out.find("passed"), std::string::npos) << good.out;
  EXPECT_EQ(good.out.find("failure"), std::string::npos) << good.out;

  // Joint 1 off by 2 mrad at one row: at some 0.8 m from it the TCP is off the seam by 1.6 mm.
  const std::string csv = test::file_text(folder.path() / "good.csv");
  folder.write("bad.csv", with_fault(csv, 20, 0.002));
  const ProgramRun bad = run_example("07_check_a_file", folder, {problem, "bad.csv"});
  EXPECT_EQ(bad.exit_code, 1) << bad.out;
  EXPECT_NE(bad.out.find("failure: "), std::string::npos) << bad.out;
  EXPECT_NE(bad.out.find("rejected"), std::string::npos) << bad.out;
  const Eigen::VectorXd q = CsvColumns(folder.path() / "bad.csv").rows(kPlanarJoints)[19];
  const Eigen::Vector3d tcp = planar_tcp(q);
  const double off = Eigen::Vector2d(std::max(0.0, std::abs(tcp.x() - 0.7) - 0.03),
                                     tcp.y() - (-0.4 + 0.8 * 19.0 / 39))
                         .norm();
  EXPECT_NEAR(number_after(bad.out, "position beyond the tolerance: "), 1000 * off, 1e-3);
}

TEST(Examples, Placement) {
  const TemporaryFolder folder;
  const ProgramRun ran =
      run_example("08_placement", folder, {shipped("problems/task_c_wrist_singularity.yaml")});
  ASSERT_EQ(ran.exit_code, 0) << ran.err << ran.out;
  // Task C stands where the wrist is singular half-way; elsewhere joints are slower.
  EXPECT_LT(number_after(ran.out, "found: "), 0.5 * number_after(ran.out, "given: "));
  const std::string speeds = ran.out.substr(ran.out.find("joint speed"));
  EXPECT_LE(number_after(speeds, "-> "), number_after(speeds, "limit: "));
  // Inside the region of the file: from 1.1, 0, 0.845 by [-0.25, 0.15] and [-0.4, 0.4].
  std::istringstream place(ran.out.substr(ran.out.find(" at ") + 4));
  double x = 0, y = 0, z = 0;
  place >> x >> y >> z;
  EXPECT_TRUE(x >= 0.85 - 1e-6 && x <= 1.25 + 1e-6 && std::abs(y) <= 0.4 + 1e-6) << ran.out;
  EXPECT_NEAR(z, 0.845, 1e-9);
}

}  // namespace
}  // namespace wristwise
