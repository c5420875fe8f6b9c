#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "io/sha256.hpp"
#include "kr5_robot_section.hpp"
#include "run_program.hpp"
#include "temporary_folder.hpp"

namespace wristwise {
namespace {

using Json = nlohmann::ordered_json;
using test::file_text;
using test::ProgramRun;
using test::replaced;
using test::run_program;
using test::TemporaryFolder;

const std::string kProblem = test::kKr5RobotSection +
                             "scene:\n"
                             "  objects: [{name: wedge, mesh: wedge.obj, xyz: [0, 2, 0]}]\n"
                             "path:\n"
                             "  speed: 0.01\n"
                             "  waypoints: 5\n"
                             "  segments: [{poses: seam.csv}]\n"
                             "  tolerance: {rz: free}\n"
                             "graph: {samples: {rz: 30 deg}}\n";

const std::string kWedge =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";

class CommandReport : public testing::Test {
 protected:
  CommandReport() {
    folder_.write("p.yaml", kProblem);
    folder_.write("wedge.obj", kWedge);
    folder_.write("seam.csv", "x,y,z,qw,qx,qy,qz\n0.9,-0.02,0.5,0,0,1,0\n0.9,0.02,0.5,0,0,1,0\n");
  }

  void expect_exit(int exit_code, const std::vector<std::string>& arguments) {
    const ProgramRun outcome = run_program(folder_.path(), arguments);
    EXPECT_EQ(outcome.exit_code, exit_code) << outcome.out << outcome.err;
  }

  bool exists(const std::string& name) const {
    return std::filesystem::exists(folder_.path() / name);
  }

  /// What a report shows.
  Json data(const std::string& folder) {
    const std::string html = file_text(folder_.path() / folder / "report.html");
    const std::string opening = "id=\"data\">";
    const std::size_t from = html.find(opening) + opening.size();
    return Json::parse(html.substr(from, html.find("</script>", from) - from));
  }

  Json result(const std::string& folder) {
    return Json::parse(file_text(folder_.path() / folder / "result.json"));
  }

  TemporaryFolder folder_;
};

TEST_F(CommandReport, PlanHashesEveryFileItRead) {
  expect_exit(0, {"plan", "p.yaml", "--out", "out"});
  const Json inputs = data("out")["inputs"];
  std::vector<std::string> names;
  for (const Json& input : inputs) {
    names.push_back(input["name"]);
    EXPECT_EQ(input["sha256"], sha256(file_text(folder_.path() / names.back()))) << names.back();
  }
  EXPECT_EQ(names, (std::vector<std::string>{"p.yaml", test::kKr5Folder + "kuka_kr5_arc.urdf",
                                             test::kKr5Folder + "joint_limits.yaml", "wedge.obj",
                                             "seam.csv"}));
}

TEST_F(CommandReport, HoldsTheResultAsItIsInTheFile) {
  expect_exit(0, {"plan", "p.yaml", "--mode", "graph-only", "--out", "out"});
  Json in_report = data("out")["result"], in_file = result("out");
  for (Json* each : {&in_report, &in_file}) each->erase("peak_rss_bytes");
  EXPECT_EQ(in_report, in_file);
  EXPECT_EQ(data("out")["motions"].size(), 1U);
}

TEST_F(CommandReport, CanBeLeftOut) {
  expect_exit(0, {"plan", "p.yaml", "--out", "out", "--no-report"});
  EXPECT_TRUE(exists("out/result.json"));
  EXPECT_FALSE(exists("out/report.html"));
  expect_exit(0, {"compare", "p.yaml", "--out", "both", "--no-report"});
  EXPECT_FALSE(exists("both/report.html"));
}

TEST_F(CommandReport, CompareAndSmoothWriteOneToo) {
  expect_exit(0, {"compare", "p.yaml", "--out", "both"});
  EXPECT_EQ(data("both")["motions"][1]["name"], "graph-only");
  EXPECT_EQ(data("both")["graph_only"]["mode"], "graph-only");
  expect_exit(0, {"smooth", "p.yaml", "--joints", "both/graph-only/trajectory.csv", "--out", "s"});
  EXPECT_EQ(data("s")["motions"][0]["name"], "smoothed");
  EXPECT_EQ(data("s")["inputs"].back()["name"], "both/graph-only/trajectory.csv");
  expect_exit(0, {"smooth", "--urdf", test::kKr5Folder + "kuka_kr5_arc.urdf", "--tip", "tool0",
                  "--limits", test::kKr5Folder + "joint_limits.yaml", "--keep", "0.5mm,0.5deg",
                  "--joints", "both/graph-only/trajectory.csv", "--out", "k"});
  EXPECT_EQ(data("k")["inputs"].size(), 3U);
}

TEST_F(CommandReport, WithoutASolutionTellsWhy) {
  folder_.write("p.yaml", replaced(kProblem, "segments:", "frame: {xyz: [5, 0, 0]}\n  segments:"));
  expect_exit(1, {"plan", "p.yaml", "--out", "out"});
  const Json shown = data("out");
  EXPECT_EQ(shown["result"]["diagnosis"][0]["reason"], "out_of_reach");
  EXPECT_TRUE(shown["motions"].empty());
}

}  // namespace
}  // namespace wristwise
