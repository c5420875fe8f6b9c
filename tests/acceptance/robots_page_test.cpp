// The walk through docs/robots.md with a robot that has no torch yet: the page's own words are run.

#include <gtest/gtest.h>

#include "run_program.hpp"

namespace wristwise {
namespace {

using test::file_text;
using test::run_program;

const std::string kSource = WRISTWISE_SOURCE_DIR;

/// The first block of a language in the section, its indentation taken off.
std::string block(const std::string& section, const std::string& language) {
  const std::string fence = "   ```";
  const std::size_t open = section.find(fence + language + "\n");
  const std::size_t begin = section.find('\n', open) + 1;
  const std::size_t end = section.find(fence + "\n", begin);
  EXPECT_NE(open, std::string::npos) << language;
  EXPECT_NE(end, std::string::npos) << language;
  std::string text;
  for (std::size_t line = begin; line < end; line = section.find('\n', line) + 1)
    text += section.substr(line + 3, section.find('\n', line) + 1 - line - 3);
  return text;
}

class RobotsPage : public testing::Test {
 protected:
  RobotsPage() {
    const std::string page = file_text(kSource + "/docs/robots.md");
    const std::size_t at = page.find("Step by step, with a maker's URDF");
    EXPECT_NE(at, std::string::npos);
    section_ = page.substr(at);
    const std::string robot = kSource + "/robots/offset_wrist_arm/";
    const std::string urdf = file_text(robot + "offset_wrist_arm.urdf");
    maker_ = urdf.substr(0, urdf.find("  <!--\n    The torch is")) + "</robot>\n";
    folder_.write("cell.urdf", maker_);
    folder_.write("joint_limits.yaml", file_text(robot + "joint_limits.yaml"));
  }

  test::ProgramRun run(const std::vector<std::string>& arguments) {
    const test::ProgramRun result = run_program(folder_.path(), arguments);
    EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
    return result;
  }

  void add_torch() {
    folder_.write("cell.urdf",
                  test::replaced(maker_, "</robot>", block(section_, "xml") + "</robot>"));
  }

  std::string section_, maker_;
  test::TemporaryFolder folder_;
};

TEST_F(RobotsPage, LooksAtTheMakersRobot) {
  const test::ProgramRun run =
      this->run({"info", "cell.urdf", "--base", "base_link", "--tip", "tool0"});
  EXPECT_NE(run.out.find("wrist_3_joint"), std::string::npos);
  EXPECT_EQ(run.out.find("torch"), std::string::npos);
}

TEST_F(RobotsPage, AddsTheTorchAndTheLimits) {
  add_torch();
  const test::ProgramRun run =
      this->run({"info", "cell.urdf", "--tip", "wire_tip", "--limits", "joint_limits.yaml"});
  EXPECT_NE(run.out.find("base_link to wire_tip, 6 joints"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("torch"), std::string::npos);
}

TEST_F(RobotsPage, PlansAndChecksTheFirstLine) {
  add_torch();
  const std::string first = block(section_, "yaml");
  folder_.write("first.yaml", first);
  run({"plan", "first.yaml"});
  run({"check", "first.yaml", "out/first/trajectory.csv"});
  folder_.write("first.yaml", test::replaced(first, "scene: {collision: off}\n", ""));
  const test::ProgramRun itself = run({"plan", "first.yaml"});
  EXPECT_EQ((itself.out + itself.err).find("left out"), std::string::npos) << itself.out;
}

}  // namespace
}  // namespace wristwise
