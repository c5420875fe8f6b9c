// Poses per second of the closed-form inverse kinematics, every branch, on one thread; and branches
// per second of their turns.

#include "wristwise/inverse_kinematics.hpp"

#include <benchmark/benchmark.h>

#include <cstdint>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "wristwise/kinematics.hpp"
#include "wristwise/urdf.hpp"

namespace wristwise {
namespace {

constexpr double kPi = 3.14159265358979323846;

std::shared_ptr<const Robot> shipped_robot() {
  const std::string folder = std::string(WRISTWISE_SOURCE_DIR) + "/robots/kuka_kr5_arc/";
  RobotSource source;
  source.urdf = folder + "kuka_kr5_arc.urdf";
  source.base_link = "base_link";
  source.tip_link = "torch_tip";
  source.limits = folder + "joint_limits.yaml";
  return std::make_shared<const Robot>(load_robot(source));
}

std::vector<Pose> reachable_poses(const Robot& robot) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> angle(-kPi, kPi);
  std::vector<Pose> poses;
  while (poses.size() < 4096) {
    JointVector q(6);
    for (double& value : q) value = angle(random);
    poses.push_back(tcp_pose(robot, q));
  }
  return poses;
}

/// A straight seam, the torch pointing down and spun about its axis by every degree.
std::vector<Pose> seam_poses() {
  std::vector<Pose> poses;
  for (int waypoint = 0; waypoint < 30; ++waypoint) {
    for (int spin = -180; spin < 180; ++spin) {
      Pose pose = Pose::Identity();
      pose.linear() << -1, 0, 0, 0, 1, 0, 0, 0, -1;
      pose.linear() = pose.linear() * Eigen::AngleAxisd(spin * kPi / 180, Eigen::Vector3d::UnitZ());
      pose.translation() << 0.9, -0.25 + 0.5 * waypoint / 29, 0.3;
      poses.push_back(pose);
    }
  }
  return poses;
}

void solve_all(benchmark::State& state, const std::vector<Pose>& poses,
               const InverseKinematics& solver) {
  std::vector<JointVector> branches;
  std::size_t total = 0;
  while (state.KeepRunning()) {
    total = 0;
    for (const Pose& pose : poses) {
      solver.solve(pose, branches);
      benchmark::DoNotOptimize(branches.data());
      total += branches.size();
    }
  }
  const auto count = static_cast<double>(poses.size());
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(poses.size()));
  state.counters["branches_per_pose"] = static_cast<double>(total) / count;
}

void random_poses(benchmark::State& state) {
  const auto robot = shipped_robot();
  solve_all(state, reachable_poses(*robot), *find_inverse_kinematics(robot).solver);
}
BENCHMARK(random_poses);

void seam_with_360_spins(benchmark::State& state) {
  solve_all(state, seam_poses(), *find_inverse_kinematics(shipped_robot()).solver);
}
BENCHMARK(seam_with_360_spins);

void turns_of_seam_branches(benchmark::State& state, Turns turns) {
  const auto robot = shipped_robot();
  const auto solver = find_inverse_kinematics(robot).solver;
  std::vector<JointVector> all, branches, copies;
  for (const Pose& pose : seam_poses()) {
    solver->solve(pose, branches);
    all.insert(all.end(), branches.begin(), branches.end());
  }
  std::size_t appended = 0;
  while (state.KeepRunning()) {
    appended = 0;
    for (const JointVector& branch : all) {
      copies.clear();
      int limiting_joint = -1;
      append_turns(*robot, branch, turns, copies, &limiting_joint);
      benchmark::DoNotOptimize(limiting_joint);
      appended += copies.size();
    }
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(all.size()));
  state.counters["copies_per_branch"] =
      static_cast<double>(appended) / static_cast<double>(all.size());
}
BENCHMARK_CAPTURE(turns_of_seam_branches, all, Turns::all);
BENCHMARK_CAPTURE(turns_of_seam_branches, principal, Turns::principal);

}  // namespace
}  // namespace wristwise
