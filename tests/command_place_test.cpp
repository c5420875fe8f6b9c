// wristwise place, as a user runs it.

#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "placement_example.hpp"
#include "run_program.hpp"

namespace wristwise {
namespace {

using Json = nlohmann::json;
using test::file_text;
using test::placement_text;
using test::ProgramRun;
using test::run_program;

class CommandPlace : public testing::Test {
 protected:
  ProgramRun place(const std::string& placement) {
    folder_.write("p.yaml", placement_text(placement));
    return run_program(folder_.path(), {"place", "p.yaml", "--out", "out"});
  }

  std::filesystem::path out(const std::string& name) { return folder_.path() / "out" / name; }
  Json json() { return Json::parse(file_text(out("placement.json"))); }

  test::TemporaryFolder folder_;
};

TEST_F(CommandPlace, WritesAPlacementThatPlanAndCheckAccept) {
  const ProgramRun run = place("{with: [plate], x: 0.2, y: 0.3, evaluations: 40, map: 3}");
  ASSERT_EQ(run.exit_code, 0) << run.out << run.err;
  EXPECT_NE(run.out.find("path.frame: {xyz: ["), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("scene.objects, plate: {xyz: ["), std::string::npos) << run.out;
  EXPECT_EQ(run.out.find("scene.objects, pillar"), std::string::npos) << run.out;
  EXPECT_EQ(json()["status"], "solved");
  EXPECT_EQ(json()["found"]["passed"], true);
  EXPECT_LT(json()["found"]["measure"]["value"], json()["given"]["measure"]["value"]);
  const auto frame = json()["found"]["frame"]["xyz"];
  EXPECT_NEAR(frame[0].get<double>() - 1, json()["found"]["offset"]["x"].get<double>(), 1e-8);

  const ProgramRun plan =
      run_program(folder_.path(), {"plan", "out/problem_placed.yaml", "--out", "again"});
  EXPECT_EQ(plan.exit_code, 0) << plan.out << plan.err;
  const Json again = Json::parse(file_text(folder_.path() / "again" / "result.json"));
  EXPECT_NEAR(again["verification"]["velocity_ratio"].get<double>(),
              json()["found"]["measure"]["speed_ratio"].get<double>(), 1e-4);
  const ProgramRun check =
      run_program(folder_.path(), {"check", "out/problem_placed.yaml", "out/plan/trajectory.csv"});
  EXPECT_EQ(check.exit_code, 0) << check.out << check.err;
}

TEST_F(CommandPlace, TheMapHasARowForEachSample) {
  ASSERT_EQ(place("{with: [plate], x: 0.2, y: 0.3, evaluations: 20, map: 4}").exit_code, 0);
  std::istringstream lines(file_text(out("map.csv")));
  std::string header, line;
  std::getline(lines, header);
  EXPECT_EQ(header.rfind("x,y,z,rx,ry,rz,measure,feasible,", 0), 0U) << header;
  const auto columns = std::count(header.begin(), header.end(), ',');
  int rows = 0;
  for (; std::getline(lines, line); ++rows)
    EXPECT_EQ(std::count(line.begin(), line.end(), ','), columns);
  EXPECT_EQ(rows, 16);
  EXPECT_NE(file_text(out("map.svg")).find("</svg>"), std::string::npos);
}

TEST_F(CommandPlace, WithoutAPlacementTheStatusIsOneAndTheReasonIsTold) {
  ASSERT_EQ(place("{with: [plate], x: 0.2, y: 0.3, evaluations: 20, map: 3}").exit_code, 0);
  const ProgramRun run = place("{with: all, x: [1.5, 2], evaluations: 20, map: 3}");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.out.find("100% out_of_reach"), std::string::npos) << run.out;
  EXPECT_EQ(json()["status"], "infeasible");
  EXPECT_TRUE(json()["found"].is_null());
  EXPECT_GE(json()["nearest"]["offset"]["x"], 1.5);
  EXPECT_FALSE(std::filesystem::exists(out("problem_placed.yaml"))) << "of the run before";
  EXPECT_FALSE(std::filesystem::exists(out("plan")));
}

TEST_F(CommandPlace, InvalidInputWritesNothing) {
  for (const std::string bad :
       {"{with: all, x: [0.2, 0.1]}", "{with: [plat]}", "{x: .nan, with: all}"}) {
    const ProgramRun run = place(bad);
    EXPECT_EQ(run.exit_code, 2) << bad;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    EXPECT_EQ(run.out, "");
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "out"));
  }
  folder_.write("q.yaml", test::replaced(placement_text("{}"), "placement: {}\n", ""));
  const ProgramRun run = run_program(folder_.path(), {"place", "q.yaml"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("'placement' is missing"), std::string::npos) << run.err;
}

TEST_F(CommandPlace, InterruptionIsAResult) {
  folder_.write("p.yaml", placement_text("{with: [plate], x: 0.2, y: 0.3, evaluations: 100000}"));
  const ProgramRun run = run_program(folder_.path(), {"place", "p.yaml", "--out", "out"},
                                     std::chrono::milliseconds(500), SIGINT);
  EXPECT_EQ(run.exit_code, 130) << run.out << run.err;
  EXPECT_EQ(json()["status"], "interrupted");
}

TEST_F(CommandPlace, PlanPassesOverTheSection) {
  folder_.write("p.yaml", placement_text("{with: [plate], x: 0.2}"));
  EXPECT_EQ(run_program(folder_.path(), {"plan", "p.yaml", "--out", "o"}).exit_code, 0);
}

}  // namespace
}  // namespace wristwise
