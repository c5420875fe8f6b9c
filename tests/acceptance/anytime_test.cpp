// A whole plan that is stopped in stage 2: what is returned is never called more than it is.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "wristwise/wristwise.hpp"

namespace wristwise {
namespace {

Problem l_profile() {
  return load_problem(std::string(WRISTWISE_SOURCE_DIR) + "/problems/task_b_l_profile.yaml");
}

bool has_diagnosis(const PlanResult& result, const std::string& reason) {
  return std::any_of(result.diagnosis.begin(), result.diagnosis.end(),
                     [&](const Diagnosis& diagnosis) { return diagnosis.reason == reason; });
}

/// The check of this very result, done again.
void expect_honest(const Problem& problem, const PlanResult& result) {
  ASSERT_FALSE(result.path.times.empty());
  const Verification again =
      result.trajectory.empty() ? check(problem, result.path) : check(problem, result.trajectory);
  EXPECT_EQ(result.verification.passed, again.passed);
  if (result.status == Status::solved) {
    EXPECT_TRUE(again.passed);
    EXPECT_FALSE(result.trajectory.empty());
    EXPECT_TRUE(result.diagnosis.empty());
  } else {
    EXPECT_FALSE(result.diagnosis.empty());
  }
}

class TimeLimit : public testing::TestWithParam<double> {};

TEST_P(TimeLimit, IsNotCalledSolvedWhereTheCheckFails) {
  Problem problem = l_profile();
  problem.refine.time_limit = GetParam();
  const PlanResult result = plan(problem);
  EXPECT_TRUE(result.status == Status::solved || result.status == Status::failed);
  expect_honest(problem, result);
}

INSTANTIATE_TEST_SUITE_P(Seconds, TimeLimit, testing::Values(1e-9, 1e-3, 0.03, 0.1, 0.3));

/// Nothing of stage 2 is there yet: the path of stage 1 holds at the waypoints, and is what comes
/// back.
TEST(TimeLimit, ReturnsTheSeedWhereStage2HasNothingThatPasses) {
  Problem problem = l_profile();
  problem.refine.time_limit = 1e-9;
  const PlanResult result = plan(problem);
  EXPECT_EQ(result.status, Status::failed);
  EXPECT_TRUE(has_diagnosis(result, "seed"));
  EXPECT_TRUE(result.trajectory.empty());
  EXPECT_TRUE(result.verification.passed);
  const PlanResult graph = plan_graph_only(problem);
  ASSERT_EQ(graph.status, Status::solved);
  ASSERT_EQ(result.path.size(), graph.path.size());
  for (std::size_t i = 0; i < graph.path.size(); ++i)
    EXPECT_EQ(result.path.positions[i], graph.path.positions[i]);
}

TEST(TimeLimit, AGenerousOneChangesNothing) {
  Problem problem = l_profile();
  const PlanResult without = plan(problem);
  problem.refine.time_limit = 1e4;
  const PlanResult with = plan(problem);
  EXPECT_EQ(with.status, Status::solved);
  ASSERT_EQ(with.trajectory.times(), without.trajectory.times());
  for (std::size_t i = 0; i < with.trajectory.times().size(); ++i)
    EXPECT_EQ(std::memcmp(with.trajectory.positions()[i].data(),
                          without.trajectory.positions()[i].data(), 6 * sizeof(double)),
              0);
  EXPECT_TRUE(with.warnings == without.warnings);
}

/// Cancelled at the given report of stage 2.
PlanResult cancelled_in_refine(const Problem& problem, int report) {
  std::atomic<bool> cancel{false};
  PlanOptions options;
  options.monitor.cancel = &cancel;
  int reports = 0;
  options.monitor.progress = [&](const std::string& stage, double) {
    if (stage == "refine" && ++reports == report) cancel = true;
  };
  PlanResult result = plan(problem, options);
  EXPECT_GE(reports, report);
  return result;
}

TEST(CancelledPlan, IsInterrupted) {
  const Problem problem = l_profile();
  for (const int report : {1, 2, 4}) {
    const PlanResult result = cancelled_in_refine(problem, report);
    EXPECT_EQ(result.status, Status::interrupted);
    EXPECT_TRUE(has_diagnosis(result, "interrupted"));
    // The seed is there to go on from.
    ASSERT_FALSE(result.seeds.empty());
    EXPECT_EQ(result.path.size(), problem.task.waypoints.size());
    if (!result.trajectory.empty()) {
      EXPECT_EQ(result.verification.passed, check(problem, result.trajectory).passed);
    }
  }
}

}  // namespace
}  // namespace wristwise
