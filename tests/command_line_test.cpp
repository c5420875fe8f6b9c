#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <regex>

#include "gantry_urdf.hpp"
#include "kr5_robot_section.hpp"
#include "run_program.hpp"
#include "temporary_folder.hpp"
#include "wristwise/trajectory_file.hpp"

namespace wristwise {
namespace {

using Json = nlohmann::json;
using test::file_text;
using test::ProgramRun;
using test::replaced;
using test::run_program;
using test::TemporaryFolder;

const std::string kProblem = test::kKr5RobotSection +
                             "scene: {collision: off}\n"
                             "path:\n"
                             "  speed: 0.01\n"
                             "  waypoints: 9\n"
                             "  segments:\n"
                             "    - line:\n"
                             "        from: {xyz: [0.9, -0.02, 0.5], rpy: [0, 180 deg, 0]}\n"
                             "        to: {xyz: [0.9, 0.02, 0.5], rpy: [0, 180 deg, 0]}\n"
                             "  tolerance: {rz: free}\n"
                             "graph: {samples: {rz: 30 deg}}\n";

class CommandLine : public testing::Test {
 protected:
  void write(const std::string& text) { folder_.write("p.yaml", text); }

  ProgramRun run(const std::vector<std::string>& arguments) {
    return run_program(folder_.path(), arguments);
  }

  Json result(const std::string& folder) {
    return Json::parse(file_text(folder_.path() / folder / "result.json"));
  }

  std::size_t entries() const {
    return static_cast<std::size_t>(
        std::distance(std::filesystem::directory_iterator(folder_.path()), {}));
  }

  /// Exit status 2, one line on stderr that names `parts`, and nothing written.
  void expect_invalid(const std::vector<std::string>& arguments,
                      const std::vector<std::string>& parts) {
    const std::size_t before = entries();
    const ProgramRun outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    for (const std::string& part : parts)
      EXPECT_NE(outcome.err.find(part), std::string::npos) << part << "\n" << outcome.err;
    EXPECT_EQ(entries(), before) << "something was written";
  }

  void expect_invalid_problem(const std::string& old_part, const std::string& new_part,
                              const std::vector<std::string>& parts) {
    write(replaced(kProblem, old_part, new_part));
    expect_invalid({"plan", "p.yaml"}, parts);
  }

  TemporaryFolder folder_;
};

TEST_F(CommandLine, MistakesInTheProblemAreInvalidInput) {
  expect_invalid_problem("  speed:", "  sped:", {"p.yaml:8", "path.sped", "'speed'"});
  expect_invalid_problem("speed: 0.01", "speed: 0", {"p.yaml:8", "path.speed"});
  expect_invalid_problem("speed: 0.01", "speed: -1", {"p.yaml:8", "path.speed"});
  expect_invalid_problem("speed: 0.01", "speed: .nan", {"p.yaml:8", "path.speed"});
  expect_invalid_problem("speed: 0.01", "speed: 10 deg", {"p.yaml:8", "path.speed", "angle"});
  expect_invalid_problem("waypoints: 9", "waypoints: 1", {"p.yaml:9", "path.waypoints"});
  expect_invalid_problem("rz: free", "rx: [2 deg, 1 deg]", {"p.yaml:14", "path.tolerance.rx"});
  expect_invalid_problem("[0.9, 0.02, 0.5]", "[0.9, -0.02, 0.5]",
                         {"p.yaml:13", "path.segments[0].line.to", "repeated waypoint"});
  expect_invalid_problem("[0.9, 0.02, 0.5]", "[0.9, .nan, 0.5]",
                         {"p.yaml:13", "path.segments[0].line.to.xyz"});
  expect_invalid_problem("kuka_kr5_arc.urdf", "none.urdf", {"p.yaml:2", "robot.urdf"});
  expect_invalid_problem("tip_link: tool0", "tip_link: tool9", {"tool9", "'tool0'"});
  expect_invalid_problem("base_link: base_link", "base_link: link_6\n  tool: {}", {"link_6"});
  expect_invalid_problem("collision: off", "objects: [{name: a, mesh: none.stl}]",
                         {"p.yaml:6", "scene.objects[0].mesh", "none.stl"});
}

TEST_F(CommandLine, WhatIsNoYamlIsNamedWithLineAndColumn) {
  write("robot:\n  urdf: a.urdf\n  base_link: [a, b\npath: 1\n");
  const ProgramRun outcome = run({"plan", "p.yaml"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_TRUE(std::regex_search(outcome.err, std::regex(R"(p\.yaml:[34]:\d+: not valid YAML)")))
      << outcome.err;
}

TEST_F(CommandLine, EmptySeam) {
  write("robot: {urdf: " + test::kKr5Folder +
        "kuka_kr5_arc.urdf}\npath: {speed: 1, segments: []}\n");
  expect_invalid({"plan", "p.yaml"}, {"p.yaml:2", "path.segments"});
}

TEST_F(CommandLine, JointWithoutLimits) {
  folder_.write("r.urdf",
                "<robot name='r'><link name='a'/><link name='b'/><joint name='lone' "
                "type='revolute'><parent link='a'/><child link='b'/><axis xyz='0 0 1'/></joint>"
                "</robot>");
  write(replaced(replaced(replaced(kProblem, test::kKr5Folder + "kuka_kr5_arc.urdf", "r.urdf"),
                          "base_link: base_link", "base_link: a"),
                 "tip_link: tool0", "tip_link: b"));
  expect_invalid({"plan", "p.yaml"}, {"r.urdf", "lone"});
}

TEST_F(CommandLine, MistakesInTheArgumentsAreInvalidInput) {
  write(kProblem);
  expect_invalid({}, {"command", "wristwise --help"});
  expect_invalid({"plna", "p.yaml"}, {"'plna'", "'plan'"});
  expect_invalid({"plan"}, {"PROBLEM"});
  expect_invalid({"plan", "none.yaml"}, {"none.yaml", "no such file"});
  expect_invalid({"plan", "p.yaml", "--mod", "graph-only"}, {"'--mod'", "'--mode'"});
  expect_invalid({"--quiet", "plan", "p.yaml", "--treads=2"}, {"'--treads'", "'--threads'"});
  expect_invalid({"plan", "p.yaml", "--json"}, {"'--json'", "wristwise plan --help"});
  expect_invalid({"--colour", "never"}, {"'--colour'", "'--color'"});
  expect_invalid({"plan", "p.yaml", "q.yaml"}, {"q.yaml", "wristwise plan --help"});
  expect_invalid({"plan", "p.yml"}, {"p.yml", "no such file"});
  expect_invalid({"plan", "q.yaml"}, {"q.yaml", "no such file", "'p.yaml'"});
  expect_invalid({"plan", "."}, {"is a folder", "p.yaml"});
  expect_invalid({"check", "p.yaml", "."}, {"is a folder", "a trajectory"});
  expect_invalid({"plan", "p.yaml", "--export", "krll"}, {"'krll'", "'krl'"});
  expect_invalid({"plan", "p.yaml", "--mode", "fast"}, {"--mode", "fast"});
  expect_invalid({"plan", "p.yaml", "--threads", "-1"}, {"--threads"});
  expect_invalid({"plan", "p.yaml", "--out", "p.yaml/deep"}, {"--out", "p.yaml"});
  expect_invalid({"check", "p.yaml", "none.csv"}, {"none.csv"});
  expect_invalid({"smooth", "p.yaml", "--joints", "none.csv"}, {"none.csv"});
  expect_invalid({"info", "none.urdf"}, {"none.urdf"});
  expect_invalid({"info", "p.yaml"}, {"p.yaml"});
}

TEST_F(CommandLine, TrajectoriesThatDoNotFitAreInvalidInput) {
  write(kProblem);
  folder_.write("t.csv", "time,joint_a1\n0,0\n1,0\n");
  expect_invalid({"check", "p.yaml", "t.csv"}, {"t.csv:1", "joint_a2"});
  folder_.write("t.csv",
                "time,joint_a1,joint_a2,joint_a3,joint_a4,joint_a5,joint_a6\n0,0,0,0,0,0,0\n"
                "9,0,0,0,0,0,0\n");
  expect_invalid({"smooth", "p.yaml", "--joints", "t.csv"}, {"9"});
}

TEST_F(CommandLine, HelpIsNoError) {
  for (const char* command : {"new", "plan", "smooth", "check", "compare", "place", "info"}) {
    const ProgramRun outcome = run({command, "--help"});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.err, "");
    EXPECT_NE(outcome.out.find("--threads"), std::string::npos);
  }
}

TEST_F(CommandLine, InfoShowsChainAndInverseKinematics) {
  const ProgramRun outcome = run({"info", test::kKr5Folder + "kuka_kr5_arc.urdf"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* part : {"joint_a1", "joint_a6", "6 joints", "inverse kinematics", "torch"})
    EXPECT_NE(outcome.out.find(part), std::string::npos) << outcome.out;
}

TEST_F(CommandLine, PlansInBothModesAndChecksItsOwnOutput) {
  write(kProblem);
  for (const std::string mode : {"two-stage", "graph-only"}) {
    const ProgramRun planned = run({"plan", "p.yaml", "--mode", mode, "--out", mode, "--quiet"});
    ASSERT_EQ(planned.exit_code, 0) << planned.out << planned.err;
    EXPECT_EQ(planned.err, "");
    EXPECT_EQ(result(mode)["status"], "solved");
    EXPECT_EQ(result(mode)["mode"], mode);
    EXPECT_EQ(result(mode)["waypoints"], 9);
    EXPECT_TRUE(result(mode)["verification"]["passed"]);
    EXPECT_EQ(std::filesystem::exists(folder_.path() / mode / "trajectory_dense.csv"),
              mode == "two-stage");
    const ProgramRun checked = run({"check", "p.yaml", mode + "/trajectory.csv"});
    EXPECT_EQ(checked.exit_code, 0) << checked.out << checked.err;
    const ProgramRun json = run({"--quiet", "check", "p.yaml", mode + "/trajectory.csv", "--json"});
    EXPECT_EQ(json.exit_code, 0);
    EXPECT_TRUE(Json::parse(json.out)["passed"]);
  }
}

TEST_F(CommandLine, FewWaypointsAreEnough) {
  for (const std::string count : {"2", "3", "4"}) {
    write(replaced(kProblem, "waypoints: 9", "waypoints: " + count));
    const ProgramRun planned = run({"plan", "p.yaml"});
    EXPECT_EQ(planned.exit_code, 0) << planned.out;
  }
}

TEST_F(CommandLine, TamperedOutputDoesNotPass) {
  write(kProblem);
  ASSERT_EQ(run({"plan", "p.yaml", "--mode", "graph-only", "--out", "out"}).exit_code, 0);
  const std::vector<std::string> joints = result("out")["joints"];
  const auto file = folder_.path() / "out" / "trajectory.csv";
  JointPath path = read_trajectory(file, joints).path;
  path.positions[1][1] += 1e-4;
  write_path(file, joints, path);
  EXPECT_EQ(run({"check", "p.yaml", "out/trajectory.csv"}).exit_code, 1);
}

TEST_F(CommandLine, ThreadsDoNotChangeAByte) {
  write(kProblem);
  ASSERT_EQ(run({"plan", "p.yaml", "--out", "one", "--threads", "1"}).exit_code, 0);
  ASSERT_EQ(run({"plan", "p.yaml", "--out", "two", "--threads", "2"}).exit_code, 0);
  for (const char* name : {"trajectory.csv", "trajectory_dense.csv"})
    EXPECT_EQ(file_text(folder_.path() / "one" / name), file_text(folder_.path() / "two" / name));
}

TEST_F(CommandLine, SmoothRepairsAPlannedPath) {
  write(kProblem);
  ASSERT_EQ(run({"plan", "p.yaml", "--mode", "graph-only", "--out", "graph"}).exit_code, 0);
  const ProgramRun smoothed =
      run({"smooth", "p.yaml", "--joints", "graph/trajectory.csv", "--out", "smooth"});
  EXPECT_EQ(smoothed.exit_code, 0) << smoothed.out << smoothed.err;
  EXPECT_EQ(result("smooth")["mode"], "smooth");
}

TEST_F(CommandLine, SmoothPutsBeforeBesideAfter) {
  write(kProblem);
  ASSERT_EQ(run({"plan", "p.yaml", "--mode", "graph-only", "--out", "graph"}).exit_code, 0);
  const ProgramRun smoothed =
      run({"smooth", "p.yaml", "--joints", "graph/trajectory.csv", "--out", "smooth"});
  for (const char* part : {"before", "after", "limit", "peak jerk of joint_a6", "violated now"})
    EXPECT_NE(smoothed.out.find(part), std::string::npos) << part << "\n" << smoothed.out;
  const Json json = result("smooth");
  for (const char* side : {"before", "after"})
    for (const char* key :
         {"velocity", "acceleration", "jerk", "velocity_ratio", "acceleration_ratio", "jerk_ratio"})
      EXPECT_TRUE(json[side]["peaks"]["joint_a6"][key].is_number()) << side << key;
  EXPECT_EQ(json["after"]["verification"], json["verification"]);
}

TEST_F(CommandLine, SmoothsWithoutAProblem) {
  folder_.write("gantry.urdf", test::kGantryUrdf);
  folder_.write("limits.yaml", "joint_limits:\n  x: {max_acceleration: 5, max_jerk: 50}\n");
  std::string recording = "time,x,y,turn\n";
  for (int i = 0; i < 40; ++i)  // 0.2 mm of noise on a slow ramp
    recording += fmt::format("{},{},{},{}\n", 0.02 * i, 0.002 * i + (i % 2) * 2e-4, 0.1, 0.01 * i);
  folder_.write("recording.csv", recording);
  const std::vector<std::string> command = {
      "smooth",   "--urdf",      "gantry.urdf", "--base",        "base",   "--tip",       "tip",
      "--limits", "limits.yaml", "--joints",    "recording.csv", "--keep", "0.5mm,0.5deg"};
  const ProgramRun outcome = run(command);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  const Json json = result("out/recording");
  EXPECT_EQ(json["status"], "solved");
  EXPECT_EQ(json["mode"], "smooth");
  EXPECT_EQ(json["waypoints"], 40);
  EXPECT_EQ(json["joints"], Json::array({"x", "y", "turn"}));
  EXPECT_EQ(json["before"]["violation_count"], 1);  // the jerk of x
  EXPECT_EQ(json["after"]["violation_count"], 0);
  EXPECT_LT(json["after"]["peaks"]["x"]["jerk"],
            0.01 * double(json["before"]["peaks"]["x"]["jerk"]));
  EXPECT_NE(outcome.out.find("jerk of x is"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("violated now: nothing"), std::string::npos) << outcome.out;

  std::vector<std::string> timed = command;
  timed.insert(timed.end(), {"--smoothing-time", "50 ms", "--out", "timed", "--no-self-collision"});
  EXPECT_EQ(run(timed).exit_code, 0);
  EXPECT_EQ(result("timed")["status"], "solved");
}

TEST_F(CommandLine, SmoothNamesWhatIsMissingOrDoesNotGoTogether) {
  write(kProblem);
  folder_.write("gantry.urdf", test::kGantryUrdf);
  folder_.write("t.csv", "time,x,y,turn\n0,0,0,0\n1,0,0,0\n");
  const auto with = [](std::vector<std::string> more) {
    more.insert(more.begin(), {"smooth", "--joints", "t.csv"});
    return more;
  };
  expect_invalid(with({}), {"PROBLEM", "--urdf"});
  expect_invalid(with({"--urdf", "gantry.urdf"}), {"--keep"});
  expect_invalid(with({"p.yaml", "--keep", "1mm,1deg"}), {"--keep", "PROBLEM"});
  expect_invalid(with({"p.yaml", "--urdf", "gantry.urdf"}), {"--urdf", "PROBLEM"});
  for (const char* keep : {"1mm", "1mm,1deg,1deg", "1deg,1mm", "1mm,x", "0mm,1deg", "-1mm,1deg",
                           "1mm,180deg", "nan,1deg", ""})
    expect_invalid(with({"--urdf", "gantry.urdf", "--keep", keep}), {"expected"});
  const auto kept = [&](std::vector<std::string> more) {
    more.insert(more.end(), {"--urdf", "gantry.urdf", "--keep", "1mm,1deg"});
    return with(std::move(more));
  };
  expect_invalid(kept({"--smoothing-time", "0"}), {"--smoothing-time"});
  expect_invalid(kept({"--smoothing-time", "1 mm"}), {"--smoothing-time"});
  expect_invalid(kept({"--tip", "tup"}), {"tup", "'tip'"});
  folder_.write("t.csv", "time,x,y\n0,0,0\n1,0,0\n");
  expect_invalid(kept({}), {"t.csv:1", "'turn'"});
  folder_.write("t.csv", "time,x,y,turn\n0,0,0,0\n1,0,nan,0\n");
  expect_invalid(kept({}), {"t.csv:3", "'y'", "finite"});
  folder_.write("t.csv", "time,x,y,turn\n0,0,0,0\n1,0,0,0\n1,0,0,0\n");
  expect_invalid(kept({}), {"t.csv:4", "increase"});
  folder_.write("t.csv", "time,x,y,turn\n0,0,0,0\n0.000001,0,0,0\n");
  expect_invalid(kept({}), {"point 1", "10 us"});
  folder_.write("t.csv", "time,x,y,turn\n0,0,0,0\n");
  expect_invalid(kept({}), {"t.csv", "at least two"});
}

TEST_F(CommandLine, WhatCannotBeSmoothedIsWrittenAsFailed) {
  // A corner at full speed, a metre per second: no curve within 0.01 mm keeps 5 m/s^2.
  folder_.write("gantry.urdf", test::kGantryUrdf);
  folder_.write("limits.yaml",
                "joint_limits:\n  x: {max_acceleration: 5}\n  y: {max_acceleration: 5}\n");
  folder_.write("t.csv", "time,x,y,turn\n0,0,0,0\n0.5,0.4,0,0\n1,0.4,0.4,0\n");
  const ProgramRun outcome = run({"smooth", "--urdf", "gantry.urdf", "--limits", "limits.yaml",
                                  "--joints", "t.csv", "--keep", "0.01mm,0.1deg", "--out", "out"});
  EXPECT_EQ(outcome.exit_code, 1) << outcome.out << outcome.err;
  EXPECT_EQ(result("out")["status"], "failed");
  EXPECT_GT(result("out")["after"]["violation_count"], 0);
  EXPECT_TRUE(std::filesystem::exists(folder_.path() / "out" / "trajectory.csv"));
}

TEST_F(CommandLine, CompareWritesBoth) {
  write(kProblem);
  const ProgramRun compared = run({"compare", "p.yaml", "--out", "both"});
  EXPECT_EQ(compared.exit_code, 0) << compared.out << compared.err;
  EXPECT_EQ(result("both/graph-only")["mode"], "graph-only");
  EXPECT_EQ(result("both/two-stage")["mode"], "two-stage");
  EXPECT_NE(compared.out.find("peak jerk of joint_a6"), std::string::npos) << compared.out;
}

TEST_F(CommandLine, DefaultFolderIsNamedAfterTheProblem) {
  write(kProblem);
  const ProgramRun planned = run({"plan", "p.yaml"});
  ASSERT_EQ(planned.exit_code, 0);
  EXPECT_EQ(result("out/p")["problem"], "p");
  EXPECT_NE(planned.out.find("next: open out/p/report.html in a browser"), std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(folder_.path() / "out/p/report.html"));
  EXPECT_EQ(run({"plan", "p.yaml", "--no-report"}).out.find("report.html"), std::string::npos);
}

TEST_F(CommandLine, OutOfReachIsDiagnosed) {
  write(replaced(replaced(kProblem, "[0.9, -0.02, 0.5]", "[1.9, -0.02, 0.5]"), "[0.9, 0.02, 0.5]",
                 "[1.9, 0.02, 0.5]"));
  for (const std::string mode : {"two-stage", "graph-only"}) {
    const ProgramRun outcome = run({"plan", "p.yaml", "--mode", mode, "--out", "out"});
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_NE(outcome.out.find("next: move the seam (path.frame)"), std::string::npos)
        << outcome.out;
    EXPECT_NE(outcome.out.find("wristwise place p.yaml"), std::string::npos) << outcome.out;
    const Json json = result("out");
    EXPECT_EQ(json["status"], "infeasible");
    ASSERT_FALSE(json["diagnosis"].empty());
    EXPECT_EQ(json["diagnosis"][0]["waypoint"], 0);
    EXPECT_EQ(json["diagnosis"][0]["reason"], "out_of_reach");
  }
}

TEST_F(CommandLine, InterruptionIsAResult) {
  write(replaced(replaced(replaced(kProblem, "waypoints: 9", "waypoints: 200"), "rz: free",
                          "rz: free, rx: 10 deg, ry: 10 deg"),
                 "rz: 30 deg", "rz: 1 deg"));
  const ProgramRun outcome = run_program(folder_.path(), {"plan", "p.yaml", "--out", "out"},
                                         std::chrono::milliseconds(300), SIGINT);
  EXPECT_EQ(outcome.exit_code, 130) << outcome.out << outcome.err;
  EXPECT_EQ(result("out")["status"], "interrupted");
  EXPECT_NE(outcome.out.find("kept: "), std::string::npos) << outcome.out;
}

}  // namespace
}  // namespace wristwise
