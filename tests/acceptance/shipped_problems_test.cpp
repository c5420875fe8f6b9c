// Every problem of problems/, in both modes: planned, written, read again, checked.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "io/result_file.hpp"
#include "temporary_folder.hpp"
#include "wristwise/wristwise.hpp"

namespace wristwise {
namespace {

const std::filesystem::path kProblems = std::string(WRISTWISE_SOURCE_DIR) + "/problems";

/// Has no path, which the tests of the paper's tasks show.
const std::string kInfeasible = "task_b_jump";

std::vector<std::string> shipped_problems() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(kProblems)) {
    const std::string name = entry.path().stem().string();
    if (entry.path().extension() == ".yaml" && name != kInfeasible) names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

class ShippedProblem : public testing::TestWithParam<std::string> {
 protected:
  /// Checks what a file of the result holds, with samples beside the bounds for all t.
  void expect_passes(const PlanResult& result) const {
    ASSERT_EQ(result.status, Status::solved)
        << (result.diagnosis.empty() ? "" : result.diagnosis.front().detail);
    EXPECT_GE(result.path.size(), problem_.task.waypoints.size());
    const std::vector<std::string> joints = problem_.robot->joint_names();
    write_result(folder_.path(), result, problem_);
    PlanOptions dense;
    dense.verification.samples_per_interval = 50;
    const Verification verification =
        check(problem_, read_trajectory(folder_.path() / "trajectory.csv", joints), dense);
    EXPECT_TRUE(verification.passed)
        << (verification.failures.empty() ? "" : verification.failures.front());
    EXPECT_EQ(verification.curve, !result.trajectory.empty());
    EXPECT_LE(verification.velocity_ratio, 1);
    EXPECT_EQ(verification.clearance.has_value(), problem_.scene.scope != CollisionScope::off);
    if (verification.clearance) {
      EXPECT_GE(*verification.clearance, problem_.scene.clearance - 1e-6);
      EXPECT_TRUE(verification.clearance_bound.has_value());
    }
  }

  Problem problem_ = load_problem(kProblems / (GetParam() + ".yaml"));
  test::TemporaryFolder folder_;
};

TEST_P(ShippedProblem, IsSolvedByTheGraph) { expect_passes(plan_graph_only(problem_)); }

TEST_P(ShippedProblem, IsSolvedInTwoStages) {
  const PlanResult result = plan(problem_);
  expect_passes(result);
  ASSERT_FALSE(result.trajectory.empty());
  double initial = 0;
  for (const CostTerm& term : result.refine.terms) initial += term.initial;
  EXPECT_LE(result.refine.objective, initial);
}

INSTANTIATE_TEST_SUITE_P(All, ShippedProblem, testing::ValuesIn(shipped_problems()),
                         [](const auto& problem) { return problem.param; });

}  // namespace
}  // namespace wristwise
