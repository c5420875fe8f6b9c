// The examples of docs/examples with arguments that they can't use: one clear line, exit 2.

#include <gtest/gtest.h>

#include <algorithm>

#include "run_example.hpp"

namespace wristwise {
namespace {

using test::ProgramRun;
using test::run_example;
using test::shipped;
using test::TemporaryFolder;

/// How an example is run well: files that it reads, then what it writes.
struct Call {
  std::string example;
  std::vector<std::string> reads, writes;

  std::vector<std::string> arguments() const {
    std::vector<std::string> all = reads;
    all.insert(all.end(), writes.begin(), writes.end());
    return all;
  }
};

const std::vector<Call> kCalls = {
    {"01_plan_a_seam", {shipped("problems/planar_3r.yaml")}, {"out.csv"}},
    {"02_graph_only", {shipped("problems/planar_3r.yaml")}, {"out.csv"}},
    {"03_smooth_a_path",
     {shipped("robots/kuka_kr5_arc/kuka_kr5_arc_round_torch.urdf"),
      shipped("robots/kuka_kr5_arc/joint_limits.yaml"), shipped("problems/recorded_path.csv")},
     {"out.csv"}},
    {"04_own_cost", {shipped("problems/slide_along_plate.yaml")}, {"."}},
    {"05_own_ik", {shipped("problems/planar_3r.yaml")}, {"out.csv", "out_2.csv"}},
    {"06_own_scene",
     {shipped("robots/kuka_kr5_arc/kuka_kr5_arc_round_torch.urdf"),
      shipped("robots/kuka_kr5_arc/joint_limits.yaml"), shipped("problems/l_profile.stl")},
     {"out.csv"}},
    {"07_check_a_file", {shipped("problems/planar_3r.yaml"), "planar.csv"}, {}},
    {"08_placement", {shipped("problems/task_c_wrist_singularity.yaml")}, {}}};

/// One line on stderr, nothing on stdout, exit 2.
void expect_refusal(const ProgramRun& ran, const std::string& part) {
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_EQ(ran.out, "");
  EXPECT_NE(ran.err.find(part), std::string::npos) << ran.err;
  EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
  EXPECT_EQ(ran.err.back(), '\n');
}

class ExampleErrors : public testing::TestWithParam<Call> {
 protected:
  /// Runs it with one of the files that it reads replaced.
  ProgramRun run_with(std::size_t which, const std::string& file) const {
    std::vector<std::string> arguments = GetParam().arguments();
    arguments[which] = file;
    return run_example(GetParam().example, folder_, arguments);
  }

  TemporaryFolder folder_;
};

TEST_P(ExampleErrors, WrongNumberOfArguments) {
  std::vector<std::string> arguments = GetParam().arguments();
  arguments.emplace_back("more");
  expect_refusal(run_example(GetParam().example, folder_, arguments), "usage: ");
  expect_refusal(run_example(GetParam().example, folder_, {}), "usage: ");
}

TEST_P(ExampleErrors, MissingFiles) {
  for (std::size_t i = 0; i < GetParam().reads.size(); ++i)
    expect_refusal(run_with(i, "not_there"), "not_there: no such file");
}

TEST_P(ExampleErrors, BadFiles) {
  folder_.write("bad", "{ not what: [it should be");
  for (std::size_t i = 0; i < GetParam().reads.size(); ++i)
    expect_refusal(run_with(i, "bad"), "bad:");
}

INSTANTIATE_TEST_SUITE_P(All, ExampleErrors, testing::ValuesIn(kCalls),
                         [](const auto& call) { return "Of" + call.param.example; });

TEST(ExampleOutput, NoFolderToWriteTo) {
  const TemporaryFolder folder;
  const ProgramRun ran = run_example("01_plan_a_seam", folder,
                                     {shipped("problems/planar_3r.yaml"), "no/such/out.csv"});
  expect_refusal(ran, "no/such/out.csv: no such folder");
}

}  // namespace
}  // namespace wristwise
