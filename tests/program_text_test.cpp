// Exported programs: byte for byte against tests/golden, and back through readers of their own.

#include <gtest/gtest.h>

#include <cmath>

#include "export/ros_yaml.hpp"
#include "export_example.hpp"
#include "invalid_input.hpp"
#include "program_readers.hpp"
#include "random_arm.hpp"
#include "temporary_folder.hpp"

namespace wristwise {
namespace {

using test::Dice;
using test::export_example;
using test::ExportExample;
using test::file_text;
using test::invalid_input;
using test::kDegree;
using test::ReadPoint;
using test::ReadProgram;
using test::says;

std::string golden(const std::string& name) {
  return file_text(std::string(WRISTWISE_SOURCE_DIR) + "/tests/golden/" + name);
}

TEST(ProgramText, IsTheGoldenFile) {
  const ExportExample example = export_example();
  const RobotProgram program = robot_program(example.result, example.problem);
  EXPECT_EQ(krl_text(program, example.problem), golden("short_weld.src"));
  EXPECT_EQ(rapid_text(program, example.problem), golden("short_weld.mod"));
  EXPECT_EQ(ls_text(program, example.problem), golden("SHORT_WELD.ls"));
  EXPECT_EQ(joint_trajectory_text(example.result, example.problem),
            golden("joint_trajectory.yaml"));
  EXPECT_EQ(robot_trajectory_text(example.result, example.problem),
            golden("robot_trajectory.yaml"));
}

/// Signs and offsets of all kinds, the rail on E2 and two axes exchanged.
std::vector<ControllerAxis> awkward_axes() {
  return {{7, -1, 0.5},          {0, -1, 0}, {1, 1, -90 * kDegree},
          {2, -1, 90 * kDegree}, {3, 1, 0},  {5, -1, 180 * kDegree},
          {4, 1, 0.25}};
}

/// What the controller shows, by hand: the rail in mm, the joints in deg.
std::map<std::string, double> awkward_values(const JointVector& q, const std::string& prefix) {
  return {{"E2", 500 - q[0] * 1e3},
          {prefix + "1", -q[1] / kDegree},
          {prefix + "2", q[2] / kDegree - 90},
          {prefix + "3", 90 - q[3] / kDegree},
          {prefix + "4", q[4] / kDegree},
          {prefix + "6", 180 - q[5] / kDegree},
          {prefix + "5", q[6] / kDegree + 0.25 / kDegree}};
}

/// A path of random points; one weld from the second point to the last but one.
ExportExample random_example(Dice& dice) {
  ExportExample example = export_example();
  const auto count = static_cast<std::size_t>(dice.uniform(4, 40));
  JointPath& path = example.result.path;
  path = {};
  double t = dice.uniform(-5, 5);
  for (std::size_t i = 0; i < count; ++i) {
    path.times.push_back(t);
    path.positions.push_back(dice.posture(7));
    t += std::pow(10, dice.uniform(-2.9, 1.6));
  }
  example.problem.task = test::task_with_runs(path.times);
  example.problem.exports.axes = awkward_axes();
  return example;
}

void expect_program(const ReadProgram& read, const JointPath& path, const std::string& prefix,
                    double axis_digits, double time_digits, int coupling) {
  ASSERT_EQ(read.points.size(), path.size());
  for (std::size_t i = 0; i < path.size(); ++i) {
    const ReadPoint& point = read.points[i];
    std::map<std::string, double> expected = awkward_values(path.positions[i], prefix);
    expected[prefix + "3"] += coupling * expected[prefix + "2"];
    ASSERT_EQ(point.axes.size(), expected.size());
    for (const auto& [name, value] : expected)
      EXPECT_NEAR(point.axes.at(name), value, axis_digits) << name << " of point " << i;
    EXPECT_NEAR(point.time, path.times[i] - path.times[0], time_digits) << "point " << i;
    EXPECT_EQ(point.welding, i > 1 && i + 1 < path.size()) << "point " << i;
  }
  EXPECT_FALSE(read.arc_left_on);
}

TEST(ProgramText, GivesJointsTimesAndWeldsBack) {
  Dice dice(5);
  for (int trial = 0; trial < 60; ++trial) {
    ExportExample example = random_example(dice);
    example.problem.exports.ls.j3_coupling = trial % 3 - 1;
    const RobotProgram program = robot_program(example.result, example.problem);
    const JointPath& path = example.result.path;
    const double duration = path.times.back() - path.times[0];
    expect_program(test::read_krl_export(krl_text(program, example.problem)), path, "A",
                   0.500001e-4, 1e-6 + duration * 0.6e-8, 0);
    expect_program(test::read_rapid_export(rapid_text(program, example.problem)), path, "A",
                   0.500001e-4, 0.51e-4, 0);
    expect_program(test::read_ls_export(ls_text(program, example.problem)), path, "J", 0.500001e-4,
                   0.0501, example.problem.exports.ls.j3_coupling);
  }
}

TEST(ProgramText, FanucTimesAreExactToTheMillisecondUpToHalfAMinute) {
  ExportExample example = export_example();
  JointPath& path = example.result.path;
  path = {};
  Dice dice(6);
  double t = 0;
  for (int i = 0; i < 2000; ++i) {
    path.times.push_back(t);
    path.positions.push_back(dice.posture(7));
    t += dice.uniform(0.0012, 0.02);
  }
  example.problem.task = test::task_with_runs(path.times);
  const ReadProgram read = test::read_ls_export(
      ls_text(robot_program(example.result, example.problem), example.problem));
  ASSERT_EQ(read.points.size(), path.size());
  for (std::size_t i = 0; i < path.size(); ++i)
    EXPECT_NEAR(read.points[i].time, path.times[i], 0.501e-3) << i;
}

TEST(ProgramText, FanucJ3CountsFromTheHorizontal) {
  ExportExample example = export_example();
  const RobotProgram program = robot_program(example.result, example.problem);
  const auto j3 = [&](int coupling) {
    example.problem.exports.ls.j3_coupling = coupling;
    return test::read_ls_export(ls_text(program, example.problem)).points[0].axes.at("J3");
  };
  EXPECT_NEAR(j3(-1), 100 + 90, 1e-4);  // J2 is -90
  EXPECT_NEAR(j3(0), 100, 1e-4);
  EXPECT_NEAR(j3(1), 100 - 90, 1e-4);
  EXPECT_EQ(ExportOptions().ls.j3_coupling, -1);
}

TEST(ProgramText, RosMessagesGiveTheSameDoublesBack) {
  Dice dice(7);
  ExportExample example = random_example(dice);
  const JointPath& path = example.result.path;
  for (const std::string& text : {joint_trajectory_text(example.result, example.problem),
                                  robot_trajectory_text(example.result, example.problem)}) {
    const test::ReadTrajectory read = test::read_ros_export(text);
    EXPECT_EQ(read.joints.size(), 7u);
    EXPECT_EQ(read.joints[0], "rail");
    ASSERT_EQ(read.positions.size(), path.size());
    for (std::size_t i = 0; i < path.size(); ++i) {
      EXPECT_NEAR(read.times[i], path.times[i] - path.times[0], 0.6e-9);
      ASSERT_EQ(read.positions[i].size(), 7u);
      for (std::size_t j = 0; j < 7; ++j)
        EXPECT_EQ(read.positions[i][j], path.positions[i][static_cast<Eigen::Index>(j)]);
      EXPECT_TRUE(read.velocities[i].empty());
    }
  }
}

TEST(ProgramText, RosMessagesOfACurveHaveItsDerivatives) {
  Dice dice(8);
  ExportExample example = random_example(dice);
  std::vector<JointVector> velocities, accelerations;
  for (std::size_t i = 0; i < example.result.path.size(); ++i) {
    velocities.push_back(dice.posture(7));
    accelerations.push_back(dice.posture(7));
  }
  example.result.trajectory = Trajectory(example.result.path.times, example.result.path.positions,
                                         velocities, accelerations);
  const test::ReadTrajectory read =
      test::read_ros_export(joint_trajectory_text(example.result, example.problem));
  ASSERT_EQ(read.velocities.size(), velocities.size());
  for (std::size_t i = 0; i < velocities.size(); ++i)
    for (std::size_t j = 0; j < 7; ++j) {
      EXPECT_EQ(read.velocities[i][j], velocities[i][static_cast<Eigen::Index>(j)]);
      EXPECT_EQ(read.accelerations[i][j], accelerations[i][static_cast<Eigen::Index>(j)]);
    }
}

TEST(ProgramText, NumbersAsPythonWritesThem) {
  EXPECT_EQ(yaml_number(0), "0.0");
  EXPECT_EQ(yaml_number(-0.0), "-0.0");
  EXPECT_EQ(yaml_number(1), "1.0");
  EXPECT_EQ(yaml_number(-2.5), "-2.5");
  EXPECT_EQ(yaml_number(0.1), "0.1");
  EXPECT_EQ(yaml_number(1e-4), "0.0001");
  EXPECT_EQ(yaml_number(1e-5), "1.0e-05");
  EXPECT_EQ(yaml_number(-1.5e-7), "-1.5e-07");
  EXPECT_EQ(yaml_number(123456), "123456.0");
  EXPECT_EQ(yaml_number(1e15), "1000000000000000.0");
  EXPECT_EQ(yaml_number(1e16), "1.0e+16");
  EXPECT_EQ(yaml_number(1.25e300), "1.25e+300");
}

TEST(ProgramText, WordsThatYamlWouldReadAsSomethingElseAreQuoted) {
  EXPECT_EQ(yaml_word("joint_a1"), "joint_a1");
  EXPECT_EQ(yaml_word(""), "''");
  EXPECT_EQ(yaml_word("yes"), "'yes'");
  EXPECT_EQ(yaml_word("1"), "'1'");
  EXPECT_EQ(yaml_word("a: b"), "'a: b'");
  EXPECT_EQ(yaml_word("it's"), "'it''s'");
}

TEST(ProgramText, NamesKeepToEachControllersRules) {
  const std::string long_name(50, 'a');
  EXPECT_EQ(program_name(ProgramFormat::krl, long_name).size(), 24u);
  EXPECT_EQ(program_name(ProgramFormat::rapid, long_name).size(), 28u);
  EXPECT_EQ(program_name(ProgramFormat::ls, long_name), std::string(36, 'A'));
  for (const ProgramFormat format : program_formats()) {
    for (const char* name :
         {"", "1st seam", "a/../b", "..", "n\xC3\xA4he", "if", "MODULE", "main", "__x", "a  b"}) {
      const std::string made = program_name(format, name);
      ASSERT_FALSE(made.empty());
      EXPECT_TRUE(std::isalpha(static_cast<unsigned char>(made[0]))) << name;
      for (const char c : made)
        EXPECT_TRUE(std::isalnum(static_cast<unsigned char>(c)) || c == '_') << name;
      std::string lower;
      for (const char c : made)
        lower += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
      EXPECT_NE(lower, "if");
      EXPECT_NE(lower, "module");
      EXPECT_NE(lower, "main");
    }
  }
  EXPECT_EQ(program_name(ProgramFormat::krl, "task-c.2"), "task_c_2");
}

TEST(ProgramText, NoWeldNoCommands) {
  ExportExample example = export_example();
  example.problem.exports.weld = false;
  const RobotProgram program = robot_program(example.result, example.problem);
  EXPECT_FALSE(says(krl_text(program, example.problem), "$OUT"));
  EXPECT_FALSE(says(rapid_text(program, example.problem), "doWeld"));
  EXPECT_FALSE(says(ls_text(program, example.problem), "Arc"));
}

TEST(ProgramText, OwnLinesToWeld) {
  ExportExample example = export_example();
  ExportOptions& options = example.problem.exports;
  options.krl.weld_on = "MY_ARC_ON()";
  options.rapid.weld_on = {"Set doGas;", "SetDO doWeld,1;"};
  options.ls.weld_on = {};
  const RobotProgram program = robot_program(example.result, example.problem);
  EXPECT_TRUE(says(krl_text(program, example.problem),
                   "  TRIGGER WHEN PATH=0 DELAY=0 DO MY_ARC_ON() PRIO=-1\n"));
  EXPECT_TRUE(says(rapid_text(program, example.problem), "    Set doGas;\n    SetDO doWeld,1;\n"));
  EXPECT_FALSE(says(ls_text(program, example.problem), "Arc Start"));
}

TEST(ProgramText, WeldOverTheWholeSeamIsSwitchedAtStandstill) {
  ExportExample example = export_example();
  for (Waypoint& waypoint : example.problem.task.waypoints) waypoint.welding = true;
  const RobotProgram program = robot_program(example.result, example.problem);
  const ReadProgram read = test::read_krl_export(krl_text(program, example.problem));
  for (std::size_t i = 1; i < read.points.size(); ++i) EXPECT_TRUE(read.points[i].welding);
  EXPECT_FALSE(read.arc_left_on);
  EXPECT_FALSE(says(krl_text(program, example.problem), "TRIGGER"));
}

TEST(ProgramText, AxesThatDoNotFitAreSaid) {
  ExportExample example = export_example();
  const auto message = [&](const std::vector<ControllerAxis>& axes) {
    example.problem.exports.axes = axes;
    return invalid_input([&] { check_export(ProgramFormat::krl, example.problem); });
  };
  EXPECT_TRUE(says(message({{0}}), "1 axes"));
  std::vector<ControllerAxis> axes = awkward_axes();
  axes[3].number = 0;
  EXPECT_TRUE(says(message(axes), "both joint_1 and joint_3 are A1"));
  axes[3].number = 12;
  EXPECT_TRUE(says(message(axes), "axis number 12"));
  axes = awkward_axes();
  axes[1].sign = 0.5;
  EXPECT_TRUE(says(message(axes), "sign"));
  axes[1].sign = 1;
  axes[1].offset = std::nan("");
  EXPECT_TRUE(says(message(axes), "not finite"));
}

TEST(ProgramText, NothingIsWrittenOfAPlanThatIsNotSolved) {
  const test::TemporaryFolder folder;
  ExportExample example = export_example();
  const auto written =
      write_program(ProgramFormat::ls, folder.path(), example.result, example.problem);
  EXPECT_EQ(written, folder.path() / "SHORT_WELD.ls");
  EXPECT_EQ(file_text(written), golden("SHORT_WELD.ls"));
  example.result.status = Status::failed;
  EXPECT_TRUE(
      write_program(ProgramFormat::ls, folder.path(), example.result, example.problem).empty());
  EXPECT_FALSE(std::filesystem::exists(written)) << "the old one is left";
}

}  // namespace
}  // namespace wristwise
