// Stage 2: known answer 2 and its growth, against one block-banded factorisation, and whole tasks.
// docs/benchmarks.md has the figures.

#include <benchmark/benchmark.h>

#include <chrono>
#include <cmath>
#include <random>

#include "benchmark_problems.hpp"
#include "block_banded.hpp"

namespace wristwise::benchmarks {
namespace {

constexpr double kKnownOptimum = 0.3200;  // J = 50 s x objective

// --- The lower bound of an iteration.

/// Diagonally dominant, otherwise random.
BlockBanded banded_matrix(int control_points) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> entry(-1, 1);
  BlockBanded matrix(control_points);
  for (int i = 0; i < control_points; ++i) {
    for (int j = std::max(0, i - BlockBanded::kBelow); j <= i; ++j) {
      BlockBanded::Block block = BlockBanded::Block::NullaryExpr([&] { return entry(random); });
      if (i == j) block = block * block.transpose() + 100 * BlockBanded::Block::Identity();
      matrix.at(i, j) = block;
    }
  }
  return matrix;
}

using Vectors = std::vector<BlockBanded::Vector>;

/// max |A x - b|, A given by its lower half.
double residual(const BlockBanded& a, const Vectors& x, const Vectors& b) {
  Vectors left = b;
  for (int i = 0; i < a.size(); ++i) {
    for (int j = std::max(0, i - BlockBanded::kBelow); j <= i; ++j) {
      left[static_cast<std::size_t>(i)] -= a.at(i, j) * x[static_cast<std::size_t>(j)];
      if (i == j) continue;
      left[static_cast<std::size_t>(j)] -= a.at(i, j).transpose() * x[static_cast<std::size_t>(i)];
    }
  }
  double largest = 0;
  for (const BlockBanded::Vector& v : left) largest = std::max(largest, v.cwiseAbs().maxCoeff());
  return largest;
}

/// Argument: control points.
void BandedFactorisation(benchmark::State& state) {
  const BlockBanded matrix = banded_matrix(static_cast<int>(state.range(0)));
  const Vectors right(static_cast<std::size_t>(matrix.size()), BlockBanded::Vector::Ones());
  Vectors x;
  for (auto _ : state) {
    BlockBanded factor = matrix;
    x = right;
    factor.factorise();
    factor.solve(x);
    benchmark::DoNotOptimize(x.data());
  }
  if (residual(matrix, x, right) > 1e-9) state.SkipWithError("not solved");
}
BENCHMARK(BandedFactorisation)
    ->Arg(55)
    ->Arg(105)
    ->Arg(1000)
    ->Arg(10000)
    ->Unit(benchmark::kMillisecond);

/// s, the best of several.
double factorisation_time(int control_points) {
  using Clock = std::chrono::steady_clock;
  const BlockBanded matrix = banded_matrix(control_points);
  double best = 1e9;
  for (int i = 0; i < 10; ++i) {
    BlockBanded factor = matrix;
    Vectors x(static_cast<std::size_t>(control_points), BlockBanded::Vector::Ones());
    const auto start = Clock::now();
    factor.factorise();
    factor.solve(x);
    benchmark::DoNotOptimize(x.data());
    best = std::min(best, std::chrono::duration<double>(Clock::now() - start).count());
  }
  return best;
}

// --- Stage 2 alone.

void report(benchmark::State& state, const PlanResult& result) {
  const RefineStatistics& refine = result.refine;
  const double per_iteration = result.timing.refine / std::max(refine.iterations, 1);
  state.counters["iterations"] = refine.iterations;
  state.counters["control_points"] = refine.control_points;
  state.counters["verify_ms"] = 1e3 * result.timing.verify;
  state.counters["violation"] = refine.max_violation;
  state.counters["ms_per_iteration"] = 1e3 * per_iteration;
  state.counters["times_factorisation"] = per_iteration / factorisation_time(refine.control_points);
}

/// Stage 2 alone: without load and verification.
PlanResult run_stage_2(benchmark::State& state, const Problem& problem, const JointPath& seed) {
  PlanResult result;
  for (auto _ : state) {
    result = smooth(problem, seed, threads(1));
    state.SetIterationTime(result.timing.refine);
  }
  if (result.status != Status::solved) {
    state.SkipWithError(result.diagnosis.empty() ? "not solved"
                                                 : result.diagnosis.front().detail.c_str());
  }
  report(state, result);
  return result;
}

JointPath known_seed(const Problem& problem, int waypoints) {
  const std::vector<std::string> names = problem.robot->joint_names();
  return read_trajectory(std::string(WRISTWISE_SOURCE_DIR) +
                             "/tests/acceptance/wrist_singularity/seed_" +
                             std::to_string(waypoints) + ".csv",
                         names)
      .path;
}

/// Argument: waypoints.
void KnownTrajectory(benchmark::State& state) {
  const Problem problem = shipped("known_trajectory");
  const JointPath seed = known_seed(problem, static_cast<int>(state.range(0)));
  const PlanResult result = run_stage_2(state, problem, seed);
  state.counters["J_ratio"] = 50 * result.refine.objective / kKnownOptimum;
}
BENCHMARK(KnownTrajectory)
    ->Arg(50)
    ->Arg(100)
    ->Arg(200)
    ->Arg(400)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

/// The path at `count` equally spaced times, straight between its points.
JointPath cut_finer(const JointPath& path, std::size_t count) {
  JointPath finer;
  std::size_t at = 0;
  const double start = path.times.front(), end = path.times.back();
  for (std::size_t i = 0; i < count; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(count - 1);
    const double t = i + 1 == count ? end : start + share * (end - start);
    while (at + 2 < path.size() && path.times[at + 1] < t) ++at;
    const double fraction = (t - path.times[at]) / (path.times[at + 1] - path.times[at]);
    finer.times.push_back(t);
    finer.positions.push_back((1 - fraction) * path.positions[at] +
                              fraction * path.positions[at + 1]);
  }
  return finer;
}

/// Argument: waypoints on the seam of known answer 2.
void GrowthWithWaypoints(benchmark::State& state) {
  const Problem problem = shipped("known_trajectory");
  const JointPath seed =
      cut_finer(known_seed(problem, 400), static_cast<std::size_t>(state.range(0)));
  const PlanResult result = run_stage_2(state, problem, seed);
  state.counters["J_ratio"] = 50 * result.refine.objective / kKnownOptimum;
  state.counters["MB"] = peak_memory([&] { smooth(problem, seed, threads(1)); });
}
BENCHMARK(GrowthWithWaypoints)
    ->Arg(100)
    ->Arg(1000)
    ->Arg(10000)
    ->UseManualTime()
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);

// --- A seam made longer: to and fro along y in rows of 1 m, joined by half circles.

constexpr double kRow = 1.0, kTurnRadius = 0.01, kStartX = 0.6, kHeight = 0.27;  // m
constexpr double kSpacing = 0.0025, kSpeed = 0.01;                               // m, m/s
constexpr double kPi = 3.14159265358979323846;

/// Torch straight down, y along the weld, which runs along +y (even rows) or -y.
Pose row_frame(int row, double y) {
  Pose frame = Pose::Identity();
  frame.linear() = Eigen::Vector3d(-1, 1, -1).asDiagonal();
  if (row % 2 == 1)
    frame.linear() = frame.linear() * Eigen::AngleAxisd(kPi, Eigen::Vector3d::UnitZ());
  frame.translation() = Eigen::Vector3d(kStartX + 2 * kTurnRadius * row, y, kHeight);
  return frame;
}

SeamPiece line(const Pose& from, const Pose& to) {
  SeamPiece piece;
  piece.from = from;
  piece.to = to;
  return piece;
}

/// From the end of a row to the beginning of the next.
SeamPiece half_circle(int row, const Pose& from, const Pose& to) {
  SeamPiece piece = line(from, to);
  piece.kind = SeamPiece::Kind::arc;
  piece.center = 0.5 * (from.translation() + to.translation());
  piece.angle = row % 2 == 0 ? -kPi : kPi;
  return piece;
}

Seam meander(double length) {
  std::vector<SeamPiece> pieces;
  double time = 0, left = length;
  const auto add = [&](SeamPiece piece) {
    piece.start_time = time;
    time += piece.length() / kSpeed;
    piece.end_time = time;
    left -= piece.length();
    pieces.push_back(piece);
  };
  for (int row = 0; left > 1e-9; ++row) {
    const double side = row % 2 == 0 ? 1 : -1, start = -side * 0.5 * kRow;
    const double end = start + side * std::min(kRow, left);
    add(line(row_frame(row, start), row_frame(row, end)));
    if (left > kPi * kTurnRadius) {
      add(half_circle(row, row_frame(row, end), row_frame(row + 1, end)));
    } else {
      break;
    }
  }
  return Seam(pieces);
}

Problem long_seam(int waypoints) {
  Problem problem = shipped("known_trajectory");
  problem.scene.scope = CollisionScope::off;
  problem.refine.smoothing_time = 1;
  const Waypoint pattern = problem.task.waypoints.front();
  problem.task.seam = meander(waypoints * kSpacing);
  problem.task.waypoints.clear();
  const double end = problem.task.seam.end_time();
  for (int i = 0; i < waypoints; ++i) {
    Waypoint waypoint = pattern;
    waypoint.time = i + 1 == waypoints ? end : end * i / (waypoints - 1);
    waypoint.frame = problem.task.seam.frame_at(waypoint.time);
    problem.task.waypoints.push_back(waypoint);
  }
  return problem;
}

/// Argument: waypoints, 2.5 mm apart; 10,000 are 25 m.
void GrowthWithLength(benchmark::State& state) {
  Problem problem = long_seam(static_cast<int>(state.range(0)));
  const PlanResult stage_1 = plan_graph_only(problem, threads(1));
  if (stage_1.status == Status::infeasible) {
    state.SkipWithError("no seed");
    return;
  }
  run_stage_2(state, problem, stage_1.path);
  state.counters["MB"] = peak_memory([&] { smooth(problem, stage_1.path, threads(1)); });
}
BENCHMARK(GrowthWithLength)
    ->Arg(100)
    ->Arg(1000)
    ->Arg(4000)
    ->Arg(10000)
    ->UseManualTime()
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);

// --- Whole tasks.

/// Both stages and verification on one thread, without loading.
void TwoStage(benchmark::State& state, const std::string& name) {
  const Problem problem = shipped(name);
  PlanResult result;
  for (auto _ : state) {
    result = plan(problem, threads(1));
    state.SetIterationTime(result.timing.total);
  }
  if (result.status != Status::solved) state.SkipWithError("not solved");
  state.counters["stage_1_ms"] = 1e3 * (result.timing.sampling + result.timing.search);
  state.counters["refine_ms"] = 1e3 * result.timing.refine;
  state.counters["verify_ms"] = 1e3 * result.timing.verify;
  state.counters["queries"] = static_cast<double>(result.refine.distance_queries);
  // Every pair at every constraint point at every evaluation.
  const ClearanceModel clearance(problem.robot, problem.scene);
  state.counters["naive_queries"] = static_cast<double>(clearance.pairs().size()) *
                                    result.refine.constraint_points * result.refine.evaluations;
}
BENCHMARK_CAPTURE(TwoStage, task_a, "task_a_cylinder")
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(TwoStage, task_b, "task_b_l_profile")
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(TwoStage, task_c, "task_c_wrist_singularity")
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace wristwise::benchmarks
