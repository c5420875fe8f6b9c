// `wristwise new`: what it writes is planned, validated by the schema, and true of the robot.

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "gantry_urdf.hpp"
#include "run_program.hpp"
#include "temporary_folder.hpp"
#include "wristwise/problem.hpp"

namespace wristwise {
namespace {

using test::file_text;
using test::ProgramRun;
using test::run_program;

const std::string kSource = WRISTWISE_SOURCE_DIR;

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

/// A key that is switched off: its lines, from the one that begins with "#" and a word.
struct SwitchedOff {
  std::size_t first, count;
};

std::vector<SwitchedOff> switched_off(const std::vector<std::string>& lines) {
  static const std::regex kKey(R"(^\s*#[A-Za-z].*)"), kBelow(R"(^\s*#  +\S.*)");
  std::vector<SwitchedOff> all;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (std::regex_match(lines[i], kKey))
      all.push_back({i, 1});
    else if (std::regex_match(lines[i], kBelow) && !all.empty() &&
             all.back().first + all.back().count == i)
      ++all.back().count;
  }
  return all;
}

std::vector<std::string> switched_on(std::vector<std::string> lines, const SwitchedOff& key) {
  for (std::size_t i = key.first; i < key.first + key.count; ++i)
    lines[i].erase(lines[i].find('#'), 1);
  return lines;
}

class NewProblem : public testing::Test {
 protected:
  ProgramRun run(const std::vector<std::string>& arguments) {
    return run_program(folder_.path(), arguments);
  }

  std::string text(const std::string& file) { return file_text(folder_.path() / file); }

  int status_of_schema(const std::string& file) {
    const std::string command = "/usr/bin/python3 " + kSource + "/tests/problem_schema.py " +
                                kSource + "/docs/problem-file.schema.json " +
                                (folder_.path() / file).string() + " > /dev/null";
    return WEXITSTATUS(std::system(command.c_str()));
  }

  void expect_valid_by_schema(const std::string& file) {
    const int status = status_of_schema(file);
    EXPECT_TRUE(status == 0 || status == 77) << file << " " << status;
  }

  void expect_solved(const std::string& file) {
    const ProgramRun planned = run({"plan", file, "--no-report"});
    EXPECT_EQ(planned.exit_code, 0) << planned.out << planned.err << text(file);
  }

  test::TemporaryFolder folder_;
};

TEST_F(NewProblem, IsPlannedAtOnceForEachShippedRobotAndSeam) {
  int robots = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(kSource + "/robots")) {
    if (entry.path().extension() != ".urdf") continue;
    ++robots;
    for (const std::string seam : {"line", "arc", "csv"}) {
      const std::string file = entry.path().stem().string() + "_" + seam + ".yaml";
      const ProgramRun made =
          run({"new", file, "--robot", entry.path().string(), "--seam", seam, "--quiet"});
      ASSERT_EQ(made.exit_code, 0) << made.err;
      EXPECT_NE(made.out.find("wristwise plan " + file), std::string::npos) << made.out;
      expect_valid_by_schema(file);
      expect_solved(file);
    }
  }
  EXPECT_GE(robots, 7);
}

TEST_F(NewProblem, IsForTheShippedRobotByDefault) {
  ASSERT_EQ(run({"new", "my_seam.yaml"}).exit_code, 0);
  EXPECT_EQ(load_problem(folder_.path() / "my_seam.yaml").robot->name(), "kuka_kr5_arc");
  expect_solved("my_seam.yaml");
}

TEST_F(NewProblem, IsOnTheTableOfAPositioner) {
  const std::string robot =
      kSource + "/robots/kuka_kr5_arc_positioner/kuka_kr5_arc_positioner.urdf";
  const ProgramRun made = run({"new", "ring.yaml", "--robot", robot, "--part", "table"});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  EXPECT_EQ(load_problem(folder_.path() / "ring.yaml").robot->part_link(), "table");
  expect_solved("ring.yaml");
}

TEST_F(NewProblem, WhatIsSwitchedOffIsValidOnceSwitchedOn) {
  for (const std::string robot : {"kuka_kr5_arc", "planar_3r"}) {
    ASSERT_EQ(run({"new", "p.yaml", "--force", "--robot",
                   kSource + "/robots/" + robot + "/" + robot + ".urdf"})
                  .exit_code,
              0);
    const std::vector<std::string> lines = lines_of(text("p.yaml"));
    const auto keys = switched_off(lines);
    EXPECT_GT(keys.size(), 40u);
    std::vector<std::string> all_on = lines;
    for (const SwitchedOff& key : keys) {
      folder_.write("on.yaml", joined(switched_on(lines, key)));
      EXPECT_NO_THROW(load_problem(folder_.path() / "on.yaml")) << lines[key.first];
      all_on = switched_on(all_on, key);
    }
    folder_.write("on.yaml", joined(all_on));
    EXPECT_NO_THROW(load_problem(folder_.path() / "on.yaml"));
    expect_valid_by_schema("on.yaml");
    if (robot == "kuka_kr5_arc") {
      EXPECT_NO_THROW(load_problem(folder_.path() / "on.yaml"));
      const ProgramRun planned = run({"plan", "on.yaml", "--no-report"});
      EXPECT_EQ(planned.exit_code, 0) << planned.out << planned.err;
    }
  }
}

TEST_F(NewProblem, HasEverySectionOfTheSchemaAndAComment) {
  ASSERT_EQ(run({"new", "p.yaml"}).exit_code, 0);
  const std::string written = text("p.yaml");
  const auto schema = nlohmann::json::parse(file_text(kSource + "/docs/problem-file.schema.json"));
  for (const auto& [section, value] : schema["properties"].items()) {
    EXPECT_TRUE(std::regex_search(written, std::regex("\n#?" + section + ":"))) << section;
    for (const auto& [key, unused] : value["properties"].items())
      EXPECT_TRUE(std::regex_search(written, std::regex("\\b" + key + "\\b")))
          << section << "." << key;
  }
  for (const std::string& line : lines_of(written)) {
    if (line.find(kSource) == std::string::npos) {
      EXPECT_LE(line.size(), 120u) << line;
    }
  }
}

TEST_F(NewProblem, JointRangesAreTheRobots) {
  folder_.write("gantry.urdf", test::kGantryUrdf);
  const ProgramRun made = run({"new", "p.yaml", "--robot", "gantry.urdf"});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  const Problem problem = load_problem(folder_.path() / "p.yaml");
  for (const Joint& joint : problem.robot->joints()) {
    std::smatch range;
    const std::string written = text("p.yaml");
    ASSERT_TRUE(std::regex_search(written, range,
                                  std::regex("#  " + joint.name + R"(: \[([^,]+), ([^\]]+)\])")))
        << written;
    EXPECT_NEAR(std::stod(range[1]), joint.lower, 1e-4);
    EXPECT_NEAR(std::stod(range[2]), joint.upper, 1e-4);
  }
  expect_solved("p.yaml");
}

TEST_F(NewProblem, IsPlannedForAnArmOfFiveAxes) {
  const std::string six = file_text(kSource + "/robots/kuka_kr5_arc/kuka_kr5_arc.urdf");
  for (const std::string held : {"joint_a4", "joint_a6"}) {
    const std::string joint = "name=\"" + held + "\" type=\"";
    folder_.write("five.urdf", test::replaced(six, joint + "revolute", joint + "fixed"));
    const ProgramRun made = run({"new", "p.yaml", "--force", "--robot", "five.urdf"});
    ASSERT_EQ(made.exit_code, 0) << held << made.err;
    EXPECT_EQ(load_problem(folder_.path() / "p.yaml").robot->joint_count(), 5);
    expect_solved("p.yaml");
  }
}

TEST_F(NewProblem, PathsLeadFromTheFilesOwnFolder) {
  std::filesystem::create_directories(folder_.path() / "cell/robots");
  std::filesystem::create_directories(folder_.path() / "cell/seams");
  for (const std::string file : {"kuka_kr5_arc.urdf", "joint_limits.yaml"})
    std::filesystem::copy(kSource + "/robots/kuka_kr5_arc/" + file,
                          folder_.path() / "cell/robots" / file);
  ASSERT_EQ(run({"new", "cell/seams/a.yaml", "--robot", "cell/robots/kuka_kr5_arc.urdf"}).exit_code,
            0);
  const std::string written = text("cell/seams/a.yaml");
  EXPECT_NE(written.find("urdf: ../robots/kuka_kr5_arc.urdf"), std::string::npos) << written;
  EXPECT_NE(written.find("limits: ../robots/joint_limits.yaml"), std::string::npos) << written;
  std::filesystem::rename(folder_.path() / "cell", folder_.path() / "moved");
  expect_solved("moved/seams/a.yaml");
}

TEST_F(NewProblem, NamesWithSpacesAndQuotesAreKept) {
  std::filesystem::create_directories(folder_.path() / "it's a cell");
  std::filesystem::copy(kSource + "/robots/kuka_kr5_arc/kuka_kr5_arc.urdf",
                        folder_.path() / "it's a cell/robot #1.urdf");
  const ProgramRun made = run({"new", "my seam.yaml", "--robot", "it's a cell/robot #1.urdf"});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  expect_solved("my seam.yaml");
}

TEST_F(NewProblem, OverwritesOnlyWhenForced) {
  folder_.write("p.yaml", "mine\n");
  const ProgramRun refused = run({"new", "p.yaml"});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_NE(refused.err.find("--force"), std::string::npos) << refused.err;
  EXPECT_EQ(text("p.yaml"), "mine\n");
  EXPECT_EQ(run({"new", "p.yaml", "--force"}).exit_code, 0);
  EXPECT_NE(text("p.yaml"), "mine\n");

  folder_.write("q.csv", "mine\n");  // that of the poses counts too
  EXPECT_EQ(run({"new", "q.yaml", "--seam", "csv"}).exit_code, 2);
  EXPECT_EQ(text("q.csv"), "mine\n");
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "q.yaml"));
}

TEST_F(NewProblem, GoesToStdout) {
  const ProgramRun made = run({"new", "-"});
  EXPECT_EQ(made.exit_code, 0);
  EXPECT_EQ(made.err, "");
  EXPECT_TRUE(std::filesystem::is_empty(folder_.path()));
  folder_.write("p.yaml", made.out);
  expect_solved("p.yaml");
  EXPECT_EQ(run({"new", "-", "--seam", "csv"}).exit_code, 2);
}

TEST_F(NewProblem, ARobotThatCannotGetsOneLine) {
  folder_.write("r.urdf",
                "<robot name='r'><link name='a'/><link name='b'/><joint name='lone' "
                "type='revolute'><parent link='a'/><child link='b'/><axis xyz='0 0 1'/>"
                "<limit lower='-1' upper='1' velocity='1' effort='0'/></joint></robot>");
  const ProgramRun made = run({"new", "p.yaml", "--robot", "r.urdf"});
  EXPECT_EQ(made.exit_code, 2) << made.out;
  EXPECT_EQ(std::count(made.err.begin(), made.err.end(), '\n'), 1) << made.err;
  EXPECT_NE(made.err.find("r.urdf"), std::string::npos) << made.err;
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "p.yaml"));
}

TEST_F(NewProblem, MistakesAreNamed) {
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{"new"},
                                                    {"new", "p.yaml", "--robot", "none.urdf"},
                                                    {"new", "no/such/folder/p.yaml"},
                                                    {"new", "."},
                                                    {"new", "p.yaml", "--seam", "spiral"}}) {
    const ProgramRun made = run(arguments);
    EXPECT_EQ(made.exit_code, 2);
    EXPECT_EQ(std::count(made.err.begin(), made.err.end(), '\n'), 1) << made.err;
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder_.path()));
}

}  // namespace
}  // namespace wristwise
