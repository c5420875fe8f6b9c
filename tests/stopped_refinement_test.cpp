// Stage 2 stopped before its end, by the time limit or by the caller.

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <optional>

#include "cancelled.hpp"
#include "refinement_example.hpp"
#include "wristwise/verification.hpp"

namespace wristwise {
namespace {

namespace gantry = test::gantry;
using test::Example;

/// Past an obstacle: a motion that holds everything is there before the best one is.
Example example() {
  ToleranceBox box = gantry::box(0, 0.1);
  box.lower[1] = -0.5;
  box.upper[1] = 0.5;
  return test::obstacle_example(box, 40);
}

/// What an early end may return: feasible only if the check agrees.
void expect_honest(const Example& example, const Refined& refined) {
  ASSERT_FALSE(refined.trajectory.empty());
  for (const JointVector& q : refined.trajectory.positions()) EXPECT_TRUE(q.allFinite());
  EXPECT_TRUE(std::isfinite(refined.statistics.objective));
  if (!refined.feasible) return;
  const Verification verification = verify(example.task, example.clearance, refined.trajectory);
  EXPECT_TRUE(verification.passed) << testing::PrintToString(verification.failures);
  EXPECT_LE(refined.statistics.max_violation, example.options.constraint_tolerance);
}

bool same_bytes(const Trajectory& a, const Trajectory& b) {
  if (a.times() != b.times()) return false;
  for (std::size_t i = 0; i < a.times().size(); ++i) {
    for (const auto member :
         {&Trajectory::positions, &Trajectory::velocities, &Trajectory::accelerations}) {
      if (std::memcmp((a.*member)()[i].data(), (b.*member)()[i].data(), 4 * sizeof(double)) != 0)
        return false;
    }
  }
  return true;
}

TEST(RefineTimeLimit, ATinyOneStopsWithoutAnException) {
  Example stopped = example();
  for (const double limit : {1e-12, 1e-9, 1e-6, 1e-4}) {
    stopped.options.time_limit = limit;
    const Refined refined = stopped.run();
    EXPECT_TRUE(refined.stopped);
    EXPECT_EQ(refined.statistics.termination, "stopped");
    expect_honest(stopped, refined);
  }
}

/// The clock decides which of the cases a limit is: all of them are checked.
TEST(RefineTimeLimit, AnyOneGivesWhatTheCheckAgreesTo) {
  Example stopped = example();
  const Refined whole = stopped.run();
  for (double limit = 2e-3; limit < 2; limit *= 2) {
    stopped.options.time_limit = limit;
    const Refined refined = stopped.run();
    expect_honest(stopped, refined);
    if (refined.statistics.termination == "converged") {
      EXPECT_TRUE(same_bytes(refined.trajectory, whole.trajectory));
    } else {
      EXPECT_TRUE(refined.stopped) << refined.statistics.termination;
    }
  }
}

TEST(RefineTimeLimit, AGenerousOneChangesNothing) {
  Example generous = example();
  const Refined whole = generous.run();
  EXPECT_TRUE(whole.feasible);
  EXPECT_FALSE(whole.stopped);
  generous.options.time_limit = 1e4;
  const Refined refined = generous.run();
  EXPECT_FALSE(refined.stopped);
  EXPECT_TRUE(same_bytes(refined.trajectory, whole.trajectory));
  EXPECT_EQ(refined.statistics.iterations, whole.statistics.iterations);
}

/// Cancelled at the given report of progress; nullopt where that throws.
std::optional<Refined> cancelled_at(Example& example, int report, int& reports) {
  std::atomic<bool> cancel{false};
  reports = 0;
  example.monitor.cancel = &cancel;
  example.monitor.progress = [&](const std::string&, double) {
    if (++reports == report) cancel = true;
  };
  try {
    return example.run();
  } catch (const Cancelled&) {
    return std::nullopt;
  }
}

/// Cancelled at each report in turn: it throws until there is a motion, then it returns the best.
void expect_best_until_then(Example example) {
  int all = 0;
  const auto whole = cancelled_at(example, -1, all);
  ASSERT_TRUE(whole && whole->feasible && !whole->stopped);
  double last = INFINITY;
  int thrown = 0, returned = 0;
  for (int report = 1; report <= all; ++report) {
    int reports = 0;
    const auto refined = cancelled_at(example, report, reports);
    EXPECT_EQ(reports, report);
    if (!refined) {
      EXPECT_EQ(returned, 0) << "a motion that was there is lost at report " << report;
      ++thrown;
      continue;
    }
    ++returned;
    EXPECT_TRUE(refined->stopped) << report << " " << refined->statistics.termination;
    EXPECT_TRUE(refined->feasible);
    expect_honest(example, *refined);
    EXPECT_LE(refined->statistics.objective, last);
    last = refined->statistics.objective;
    EXPECT_GE(last, (1 - 1e-4) * whole->statistics.objective);
  }
  EXPECT_GT(thrown, 0);
  EXPECT_GT(returned, 0);
}

/// A seam with a bend in it.
Example bent(double box) {
  return {gantry::parts(), gantry::task({{0, 0, 0}, {0.5, 0.3, 0}, {1, 0, 0}}, test::kDuration, 120,
                                        gantry::box(box, 0.1))};
}

/// Between two rounds: everything holds before the objective has settled.
TEST(RefineCancelled, ReturnsTheBestMotionOfTheRoundsBefore) { expect_best_until_then(bent(0.2)); }

TEST(RefineCancelled, ReturnsTheBestMotionFromRest) {
  Example example = bent(0.05);
  example.task.rest_at_start = true;
  expect_best_until_then(example);
}

}  // namespace
}  // namespace wristwise
