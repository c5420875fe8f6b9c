// Stage 1: against a plain dynamic programme, with several tolerances, with collision checks, and
// its growth. docs/benchmarks.md has the figures.

#include <benchmark/benchmark.h>

#include "benchmark_problems.hpp"
#include "plain_dynamic_programme.hpp"

namespace wristwise::benchmarks {
namespace {

void report(benchmark::State& state, const PlanResult& result) {
  state.counters["vertices"] = static_cast<double>(result.graph.vertices);
  state.counters["edges"] = result.graph.edges;
  state.counters["evaluated"] = result.graph.edges_evaluated;
  state.counters["sampling_ms"] = 1e3 * result.timing.sampling;
  state.counters["search_ms"] = 1e3 * result.timing.search;
}

/// Stage 1 alone: sampling and search, without load and verification.
void run_stage_1(benchmark::State& state, const Problem& problem, int thread_count) {
  PlanResult result;
  for (auto _ : state) {
    result = plan_graph_only(problem, threads(thread_count));
    state.SetIterationTime(result.timing.sampling + result.timing.search);
  }
  if (result.status != Status::solved) state.SkipWithError("not solved");
  report(state, result);
}

Problem known_graph(bool turns) {
  Problem problem = shipped("known_graph");
  problem.graph.turns = turns ? Turns::all : Turns::principal;
  return problem;
}

/// Argument: 0 without, 1 with copies by whole turns.
void KnownGraphPlainProgramme(benchmark::State& state) {
  const Problem problem = known_graph(state.range(0) != 0);
  const auto ik = find_inverse_kinematics(problem.robot).solver;
  PlainResult result;
  for (auto _ : state) result = plain_dynamic_programme(problem, *ik);
  state.counters["vertices"] = static_cast<double>(result.vertices);
  state.counters["MB"] = peak_memory([&] { plain_dynamic_programme(problem, *ik); });
}
BENCHMARK(KnownGraphPlainProgramme)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

void KnownGraph(benchmark::State& state) {
  const Problem problem = known_graph(state.range(0) != 0);
  run_stage_1(state, problem, 1);
  state.counters["MB"] = peak_memory([&] { plan_graph_only(problem, threads(1)); });
}
BENCHMARK(KnownGraph)->Arg(0)->Arg(1)->UseManualTime()->Unit(benchmark::kMillisecond);

/// What a process needs that has loaded the problem and does nothing.
void EmptyProcess(benchmark::State& state) {
  const Problem problem = known_graph(false);
  for (auto _ : state) benchmark::ClobberMemory();
  state.counters["MB"] = peak_memory([] {});
}
BENCHMARK(EmptyProcess);

/// Argument: threads.
void SeveralTolerances(benchmark::State& state) {
  const Problem problem = shipped("known_graph_wide");
  const int count = static_cast<int>(state.range(0));
  run_stage_1(state, problem, count);
  state.counters["MB"] = peak_memory([&] { plan_graph_only(problem, threads(count)); });
}
BENCHMARK(SeveralTolerances)->Arg(1)->Arg(2)->UseManualTime()->Unit(benchmark::kMillisecond);

/// Argument: 0 lazy, 1 eager collision checks.
void TaskB(benchmark::State& state) {
  Problem problem = shipped("task_b_l_profile");
  problem.graph.collision_checks =
      state.range(0) != 0 ? CollisionChecks::eager : CollisionChecks::lazy;
  run_stage_1(state, problem, 1);
  const PlanResult result = plan_graph_only(problem, threads(1));
  state.counters["postures"] = static_cast<double>(result.graph.postures);
  state.counters["postures_checked"] = static_cast<double>(result.graph.postures_checked);
  state.counters["moves_checked"] = static_cast<double>(result.graph.edges_checked);
}
BENCHMARK(TaskB)->Arg(0)->Arg(1)->UseManualTime()->Unit(benchmark::kMillisecond);

/// Argument: waypoints, with 36 spins each.
void GrowthWithWaypoints(benchmark::State& state) {
  Problem problem = known_graph(true);
  problem.graph.step[5] = 10 * 0.017453292519943295;
  const Task one = problem.task;
  const auto count = static_cast<std::size_t>(state.range(0));
  problem.task.waypoints.clear();
  const double start = one.seam.start_time(), end = one.seam.end_time();
  for (std::size_t i = 0; i < count; ++i) {
    Waypoint waypoint = one.waypoints.front();
    waypoint.time = start + (end - start) * static_cast<double>(i) / static_cast<double>(count - 1);
    waypoint.frame = one.seam.frame_at(waypoint.time);
    problem.task.waypoints.push_back(waypoint);
  }
  run_stage_1(state, problem, 1);
  state.counters["MB"] = peak_memory([&] { plan_graph_only(problem, threads(1)); });
}
BENCHMARK(GrowthWithWaypoints)
    ->RangeMultiplier(10)
    ->Range(100, 100000)
    ->UseManualTime()
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);

/// Argument: spins at each of 30 waypoints.
void GrowthWithSamples(benchmark::State& state) {
  Problem problem = known_graph(true);
  problem.graph.step[5] = 6.283185307179586 / static_cast<double>(state.range(0));
  run_stage_1(state, problem, 1);
  state.counters["MB"] = peak_memory([&] { plan_graph_only(problem, threads(1)); });
}
BENCHMARK(GrowthWithSamples)
    ->RangeMultiplier(4)
    ->Range(36, 36 * 1024)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

/// The experiment of fig. 9 of the ETFA 2017 paper: 50 points, +-45 deg about the path and +-9 deg
/// about the torch. Argument: 0 dense, 1 sparse.
void Figure9(benchmark::State& state) {
  Problem problem = shipped("known_graph");
  constexpr double kPi = 3.14159265358979323846;
  for (Waypoint& waypoint : problem.task.waypoints) {
    waypoint.tolerance.lower[4] = -kPi / 4;
    waypoint.tolerance.upper[4] = kPi / 4;
    waypoint.tolerance.lower[5] = -kPi / 20;
    waypoint.tolerance.upper[5] = kPi / 20;
  }
  const Task one = problem.task;
  problem.task.waypoints.clear();
  for (int i = 0; i < 50; ++i) {
    Waypoint waypoint = one.waypoints.front();
    waypoint.time = one.seam.end_time() * i / 49;
    waypoint.frame = one.seam.frame_at(waypoint.time);
    problem.task.waypoints.push_back(waypoint);
  }
  problem.graph.step[4] = kPi / 40;
  problem.graph.step[5] = kPi / 40;
  problem.graph.planner = state.range(0) != 0 ? Planner::sparse : Planner::dense;
  run_stage_1(state, problem, 1);
  const PlanResult result = plan_graph_only(problem, threads(1));
  state.counters["points"] =
      static_cast<double>(state.range(0) != 0 ? result.graph.sparse_points : 50);
  state.counters["replans"] = result.graph.replans;
  state.counters["cost"] = result.graph.cost;
  state.counters["postures"] = static_cast<double>(result.graph.postures);
  state.counters["MB"] = peak_memory([&] { plan_graph_only(problem, threads(1)); });
}
BENCHMARK(Figure9)->Arg(0)->Arg(1)->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace wristwise::benchmarks
