// Smoothing a noisy recording without a problem: the parts, and the whole. Argument: rows.
// docs/smoothing.md has the figures.

#include <benchmark/benchmark.h>

#include <filesystem>

#include "benchmark_problems.hpp"
#include "io/result_file.hpp"
#include "recording.hpp"

namespace wristwise::benchmarks {
namespace {

constexpr double kStep = 0.01;   // s between rows
constexpr double kNoise = 2e-5;  // rad

std::shared_ptr<const Robot> torch_robot() {
  const std::string folder = std::string(WRISTWISE_SOURCE_DIR) + "/robots/kuka_kr5_arc/";
  RobotSource source;
  source.urdf = folder + "kuka_kr5_arc_round_torch.urdf";
  source.tip_link = "torch_tip";
  source.limits = folder + "joint_limits.yaml";
  return std::make_shared<const Robot>(load_robot(source));
}

std::vector<std::string> joint_names(const Robot& robot) {
  const std::vector<std::string> names = robot.joint_names();
  return names;
}

JointPath recording(const benchmark::State& state) {
  const auto rows = static_cast<std::size_t>(state.range(0));
  return test::record(test::kr5_swing(), test::recording_times(rows, kStep), kNoise);
}

/// The motion that was recorded, as a curve: what a perfect solver would give.
Trajectory recorded_motion(const benchmark::State& state) {
  const test::Swing swing = test::kr5_swing();
  const auto times = test::recording_times(static_cast<std::size_t>(state.range(0)), kStep);
  std::vector<JointVector> q, v, a;
  for (const double t : times) {
    q.push_back(swing.at(t));
    v.push_back(swing.at(t, 1));
    a.push_back(swing.at(t, 2));
  }
  return {times, q, v, a};
}

std::filesystem::path scratch_folder() {
  return std::filesystem::temp_directory_path() / "wristwise_smoothing_benchmark";
}

void ReadRecording(benchmark::State& state) {
  const auto robot = torch_robot();
  std::filesystem::create_directories(scratch_folder());
  const auto file = scratch_folder() / "recording.csv";
  write_path(file, joint_names(*robot), recording(state));
  for (auto _ : state) benchmark::DoNotOptimize(read_trajectory(file, joint_names(*robot)));
  std::filesystem::remove_all(scratch_folder());
}

void MakeProblem(benchmark::State& state) {
  const auto robot = torch_robot();
  const JointPath path = recording(state);
  for (auto _ : state) benchmark::DoNotOptimize(smoothing_problem(robot, path));
}

void CheckRecording(benchmark::State& state) {
  const SmoothingProblem given = smoothing_problem(torch_robot(), recording(state));
  for (auto _ : state) benchmark::DoNotOptimize(check(given.problem, given.path));
}

void CheckCurve(benchmark::State& state) {
  const SmoothingProblem given = smoothing_problem(torch_robot(), recording(state));
  const Trajectory curve = recorded_motion(state);
  for (auto _ : state) benchmark::DoNotOptimize(check(given.problem, curve));
}

void WriteResult(benchmark::State& state) {
  const SmoothingProblem given = smoothing_problem(torch_robot(), recording(state));
  PlanResult result;
  result.mode = Mode::smooth;
  result.trajectory = recorded_motion(state);
  result.path = result.trajectory.waypoints();
  result.before = {given.path, {}};
  for (auto _ : state) write_result(scratch_folder(), result, given.problem);
  std::filesystem::remove_all(scratch_folder());
}

void Smooth(benchmark::State& state) {
  const auto robot = torch_robot();
  const JointPath path = recording(state);
  PlanResult result;
  for (auto _ : state) result = smooth(robot, path, {}, threads(1));
  if (result.status != Status::solved) state.SkipWithError("not solved");
  state.counters["refine_s"] = result.timing.refine;
  state.counters["verify_s"] = result.timing.verify;
  state.counters["iterations"] = result.refine.iterations;
  state.counters["control_points"] = result.refine.control_points;
}

#define WRISTWISE_SIZES Arg(1000)->Arg(10000)->Arg(100000)->Unit(benchmark::kMillisecond)
BENCHMARK(ReadRecording)->WRISTWISE_SIZES;
BENCHMARK(MakeProblem)->WRISTWISE_SIZES;
BENCHMARK(CheckRecording)->WRISTWISE_SIZES;
BENCHMARK(CheckCurve)->WRISTWISE_SIZES;
BENCHMARK(WriteResult)->WRISTWISE_SIZES;
BENCHMARK(Smooth)->WRISTWISE_SIZES;

}  // namespace
}  // namespace wristwise::benchmarks
