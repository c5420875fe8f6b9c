// The independent check of the shipped tasks, and the search between waypoints that stage 2 makes.

#include <benchmark/benchmark.h>

#include <array>
#include <optional>

#include "benchmark_problems.hpp"
#include "refine/breakpoints.hpp"
#include "refine/dip_search.hpp"

namespace wristwise::benchmarks {
namespace {

const std::array<const char*, 4> kProblems = {"task_a_cylinder", "task_b_l_profile",
                                              "task_c_wrist_singularity", "known_trajectory"};

struct Planned {
  Problem problem;
  PlanResult result;
  std::shared_ptr<const ClearanceModel> clearance;
};

/// Each problem is planned once.
const Planned& planned(std::int64_t index) {
  static std::array<std::optional<Planned>, kProblems.size()> all;
  auto& one = all[static_cast<std::size_t>(index)];
  if (!one) {
    Problem problem = shipped(kProblems[static_cast<std::size_t>(index)]);
    PlanResult result = plan(problem, threads(1));
    auto clearance = std::make_shared<const ClearanceModel>(problem.robot, problem.scene);
    one = Planned{std::move(problem), std::move(result), std::move(clearance)};
  }
  return *one;
}

void Verify(benchmark::State& state) {
  const Planned& of = planned(state.range(0));
  Verification verification;
  for (auto _ : state) {
    verification = verify(of.problem.task, of.clearance, of.result.trajectory);
    benchmark::DoNotOptimize(verification);
  }
  state.SetLabel(kProblems[static_cast<std::size_t>(state.range(0))]);
  state.counters["passed"] = verification.passed;
  state.counters["postures"] = static_cast<double>(verification.samples);
  state.counters["queries"] = static_cast<double>(verification.distance_queries);
}
BENCHMARK(Verify)->DenseRange(0, 3)->Unit(benchmark::kMillisecond);

void VerifyPoints(benchmark::State& state) {
  const Planned& of = planned(state.range(0));
  Verification verification;
  for (auto _ : state) {
    verification = verify(of.problem.task, of.clearance, of.result.seeds.front().path);
    benchmark::DoNotOptimize(verification);
  }
  state.SetLabel(kProblems[static_cast<std::size_t>(state.range(0))]);
  state.counters["postures"] = static_cast<double>(verification.samples);
  state.counters["queries"] = static_cast<double>(verification.distance_queries);
}
BENCHMARK(VerifyPoints)->DenseRange(0, 3)->Unit(benchmark::kMillisecond);

void FindDips(benchmark::State& state) {
  const Planned& of = planned(state.range(0));
  const JointPath path = of.result.trajectory.waypoints();
  const Spline spline = fit_spline(path, choose_breakpoints(path.times, path.times.back() / 100));
  const double epsilon = of.problem.refine.clearance_epsilon;
  const double required = of.clearance->clearance() + 0.5 * epsilon;
  ClearanceChecker checker(of.clearance);
  std::size_t dips = 0;
  for (auto _ : state) {
    dips = find_dips(of.problem.task, spline, checker, required, 0.5 * epsilon).size();
    benchmark::DoNotOptimize(dips);
  }
  state.SetLabel(kProblems[static_cast<std::size_t>(state.range(0))]);
  state.counters["dips"] = static_cast<double>(dips);
  state.counters["queries"] =
      static_cast<double>(checker.queries()) / static_cast<double>(state.iterations());
  state.counters["naive_queries"] = static_cast<double>(
      10 * (of.problem.task.waypoints.size() - 1) * of.clearance->pairs().size());
}
BENCHMARK(FindDips)->DenseRange(0, 3)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace wristwise::benchmarks
