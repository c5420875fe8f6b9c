// --export on the command line, and programs as input of smooth and plan.

#include <gtest/gtest.h>

#include <algorithm>

#include "program_readers.hpp"
#include "run_program.hpp"
#include "wristwise/trajectory_file.hpp"

namespace wristwise {
namespace {

using test::file_text;
using test::ProgramRun;
using test::ReadProgram;

const std::string kRobotFolder = std::string(WRISTWISE_SOURCE_DIR) + "/robots/kuka_kr5_arc/";
const std::string kProblem =
    "robot: {urdf: " + kRobotFolder +
    "kuka_kr5_arc.urdf, base_link: base_link, tip_link: tool0, limits: " + kRobotFolder +
    "joint_limits.yaml}\nscene: {collision: off}\npath:\n  speed: 10 mm/s\n  waypoints: 9\n"
    "  run_in: 10 mm\n  run_out: 10 mm\n  segments:\n    - line:\n"
    "        from: {xyz: [0.9, -0.02, 0.5], rpy: [0, 180 deg, 0]}\n"
    "        to: {xyz: [0.9, 0.02, 0.5], rpy: [0, 180 deg, 0]}\n  tolerance: {rz: free}\n"
    "graph: {samples: {rz: 30 deg}}\n"
    "export: {name: SEAM, period: 100 ms, joints: {joint_a1: {axis: A1, sign: -1}, joint_a2: A2, "
    "joint_a3: A3, joint_a4: A4, joint_a5: A5, joint_a6: {axis: A6, offset: 90 deg}}}\n";

class ExportCommand : public testing::Test {
 protected:
  ProgramRun run(const std::vector<std::string>& arguments) {
    return test::run_program(folder_.path(), arguments);
  }
  std::filesystem::path out(const std::string& name) { return folder_.path() / "out" / name; }

  /// Plans once with all formats.
  ProgramRun plan() {
    folder_.write("p.yaml", kProblem);
    return run({"plan", "p.yaml", "--out", "out", "--quiet", "--export", "krl,rapid", "--export",
                "ls", "--export", "trajectory_msgs,moveit"});
  }

  /// The program has the joints of the dense trajectory at its times.
  void expect_follows(const ReadProgram& program, const std::string& prefix) {
    const TrajectoryFile dense =
        read_trajectory(out("trajectory_dense.csv"),
                        {"joint_a1", "joint_a2", "joint_a3", "joint_a4", "joint_a5", "joint_a6"});
    ASSERT_TRUE(dense.trajectory);
    const double start = dense.path.times.front();
    constexpr double kDegree = 3.14159265358979323846 / 180;
    ASSERT_GT(program.points.size(), 50u);
    for (const test::ReadPoint& point : program.points) {
      const JointVector q = dense.trajectory->evaluate(start + point.time);
      EXPECT_NEAR(point.axes.at(prefix + "1"), -q[0] / kDegree, 2e-3) << point.time;
      EXPECT_NEAR(point.axes.at(prefix + "2"), q[1] / kDegree, 2e-3);
      EXPECT_NEAR(point.axes.at(prefix + "6"), q[5] / kDegree + 90, 2e-3);
    }
    EXPECT_NEAR(program.points.back().time, dense.path.times.back() - start, 1e-3);
    double weld = 0;
    for (std::size_t i = 1; i < program.points.size(); ++i)
      if (program.points[i].welding) weld += program.points[i].time - program.points[i - 1].time;
    EXPECT_NEAR(weld, 4, 2e-3) << "40 mm at 10 mm/s";
    EXPECT_FALSE(program.arc_left_on);
  }

  test::TemporaryFolder folder_;
};

TEST_F(ExportCommand, WritesEachFormat) {
  const ProgramRun outcome = plan();
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err << outcome.out;
  for (const char* name : {"SEAM.src", "SEAM.mod", "SEAM.ls", "joint_trajectory.yaml",
                           "robot_trajectory.yaml", "trajectory.csv", "result.json"}) {
    EXPECT_TRUE(std::filesystem::exists(out(name))) << name;
  }
  EXPECT_NE(outcome.out.find("exported out/SEAM.src"), std::string::npos) << outcome.out;
  expect_follows(test::read_krl_export(file_text(out("SEAM.src"))), "A");
  expect_follows(test::read_rapid_export(file_text(out("SEAM.mod"))), "A");
  expect_follows(test::read_ls_export(file_text(out("SEAM.ls"))), "J");
}

TEST_F(ExportCommand, ProgramsAreSmoothed) {
  ASSERT_EQ(plan().exit_code, 0);
  for (const char* name : {"SEAM.src", "SEAM.mod", "SEAM.ls", "joint_trajectory.yaml"}) {
    const ProgramRun outcome =
        run({"smooth", "--urdf", kRobotFolder + "kuka_kr5_arc.urdf", "--base", "base_link", "--tip",
             "tool0", "--limits", kRobotFolder + "joint_limits.yaml", "--joints",
             "out/" + std::string(name), "--keep", "1mm,1deg", "--no-self-collision", "--out",
             "smooth", "--quiet", "--export", "krl"});
    EXPECT_LE(outcome.exit_code, 1) << name << outcome.err;
    EXPECT_EQ(outcome.err, "") << name;
    EXPECT_TRUE(std::filesystem::exists(folder_.path() / "smooth" / "result.json")) << name;
  }
}

TEST_F(ExportCommand, ProgramsAreSmoothedWithTheProblemThatTheyCameFrom) {
  ASSERT_EQ(plan().exit_code, 0);  // its run-in begins before time 0
  for (const char* name : {"SEAM.src", "SEAM.mod", "SEAM.ls"}) {
    const ProgramRun outcome = run(
        {"smooth", "p.yaml", "--joints", "out/" + std::string(name), "--out", "smooth", "--quiet"});
    EXPECT_EQ(outcome.exit_code, 0) << name << outcome.err << outcome.out;
  }
}

TEST_F(ExportCommand, AnUnknownFormatIsSaidBeforePlanning) {
  folder_.write("p.yaml", kProblem);
  const ProgramRun outcome = run({"plan", "p.yaml", "--out", "out", "--export", "krl,rapit"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("'rapit'"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("rapid"), std::string::npos) << outcome.err;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1);
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "out"));
  EXPECT_EQ(run({"plan", "p.yaml", "--export", ""}).exit_code, 2);
}

TEST_F(ExportCommand, AProgramThatIsNotUnderstoodIsOneLine) {
  folder_.write("p.yaml", kProblem);
  folder_.write("a.src", "DEF a()\nPTP {A1 0,A2 -90,A3 90,A4 0,A5 0,A6 0}\nLOOP\nENDLOOP\nEND\n");
  const ProgramRun outcome = run({"smooth", "p.yaml", "--joints", "a.src", "--out", "out"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("a.src:3: 'LOOP' is not understood"), std::string::npos)
      << outcome.err;
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "out"));
}

}  // namespace
}  // namespace wristwise
