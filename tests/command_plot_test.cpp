#include <gtest/gtest.h>

#include "kr5_robot_section.hpp"
#include "plot_reader.hpp"
#include "run_program.hpp"
#include "temporary_folder.hpp"

namespace wristwise {
namespace {

using test::file_text;
using test::PlotReader;
using test::ProgramRun;
using test::replaced;
using test::run_program;

const std::string kProblem =
    test::kKr5RobotSection +
    "path:\n"
    "  speed: 0.01\n"
    "  waypoints: 5\n"
    "  segments: [{line: {from: {xyz: [0.9, -0.02, 0.5], rpy: [0, 180 deg, 0]}, "
    "to: {xyz: [0.9, 0.02, 0.5], rpy: [0, 180 deg, 0]}}}]\n"
    "  tolerance: {rz: free}\n"
    "graph: {samples: {rz: 30 deg}}\n";

class CommandPlot : public testing::Test {
 protected:
  CommandPlot() { folder_.write("p.yaml", kProblem); }

  ProgramRun expect_exit(int exit_code, const std::vector<std::string>& arguments) {
    ProgramRun outcome = run_program(folder_.path(), arguments);
    EXPECT_EQ(outcome.exit_code, exit_code) << outcome.out << outcome.err;
    return outcome;
  }

  bool exists(const std::string& name) const {
    return std::filesystem::exists(folder_.path() / name);
  }

  PlotReader read(const std::string& name) const {
    return PlotReader(file_text(folder_.path() / name));
  }

  test::TemporaryFolder folder_;
};

using Names = std::vector<std::string>;

TEST_F(CommandPlot, PlanDrawsOnRequestAndSaysWhat) {
  EXPECT_EQ(expect_exit(0, {"plan", "p.yaml", "--out", "o"}).out.find(".svg"), std::string::npos);
  EXPECT_FALSE(exists("o/joints.svg"));
  const ProgramRun run = expect_exit(0, {"plan", "p.yaml", "--out", "o", "--plot"});
  for (const std::string name : {"joints.svg", "joint_positions.svg", "tolerance.svg"}) {
    EXPECT_TRUE(exists("o/" + name));
    EXPECT_NE(run.out.find("picture o/" + name), std::string::npos) << run.out;
  }
  EXPECT_EQ(read("o/joints.svg").lines("joint_a4 velocity"), (Names{"graph-only", "two-stage"}));
}

TEST_F(CommandPlot, CompareAndSmoothDrawBoth) {
  expect_exit(0, {"compare", "p.yaml", "--out", "c", "--plot"});
  EXPECT_EQ(read("c/tolerance.svg").lines("rz deviation"),
            (Names{"lower edge", "upper edge", "graph-only", "two-stage"}));
  expect_exit(0, {"smooth", "p.yaml", "--joints", "c/graph-only/trajectory.csv", "--out", "s",
                  "--plot", "--no-report"});
  EXPECT_EQ(read("s/joints.svg").lines("joint_a4 velocity"), (Names{"as given", "smoothed"}));
  expect_exit(0, {"smooth", "--urdf", test::kKr5Folder + "kuka_kr5_arc.urdf", "--tip", "tool0",
                  "--limits", test::kKr5Folder + "joint_limits.yaml", "--keep", "0.5mm,0.5deg",
                  "--joints", "c/graph-only/trajectory.csv", "--out", "k", "--plot"});
  EXPECT_EQ(read("k/joints.svg").lines("joint_a4 jerk"), (Names{"as given", "smoothed"}));
}

TEST_F(CommandPlot, WithoutAMotionSaysSoAndLeavesNoOldPicture) {
  expect_exit(0, {"plan", "p.yaml", "--out", "o", "--plot"});
  folder_.write("p.yaml", replaced(kProblem, "segments:", "frame: {xyz: [5, 0, 0]}\n  segments:"));
  const ProgramRun run = expect_exit(1, {"plan", "p.yaml", "--out", "o", "--plot"});
  EXPECT_NE(run.out.find("no pictures: there is no motion"), std::string::npos) << run.out;
  EXPECT_FALSE(exists("o/joints.svg"));
}

TEST_F(CommandPlot, IsTheSameWhateverTheNumberOfThreads) {
  for (const std::string threads : {"1", "3"})
    expect_exit(0, {"plan", "p.yaml", "--out", "t" + threads, "--plot", "--threads", threads});
  for (const std::string name : {"joints.svg", "joint_positions.svg", "tolerance.svg"})
    EXPECT_EQ(file_text(folder_.path() / "t1" / name), file_text(folder_.path() / "t3" / name));
}

}  // namespace
}  // namespace wristwise
