// Poses per second of the inverse kinematics, every branch, on one thread, and branches per second
// of their turns. Of the numeric one also how much it finds: the share of random poses (of postures
// inside the limits) with a solution inside the limits, and the share of the closed form's
// solutions.

#include "wristwise/inverse_kinematics.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "dh_arms.hpp"
#include "kinematics/descent.hpp"
#include "kinematics/nearest_in_cell.hpp"
#include "ur_closed_form.hpp"
#include "wristwise/kinematics.hpp"
#include "wristwise/numeric_inverse_kinematics.hpp"
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

constexpr int kNumericPoses = 10000;

std::vector<Pose> poses_inside_limits(const Robot& robot, int count) {
  std::mt19937 random(7);
  std::vector<Pose> poses;
  for (int i = 0; i < count; ++i) {
    JointVector q(robot.joint_count());
    for (int j = 0; j < robot.joint_count(); ++j) {
      const Joint& joint = robot.joints()[static_cast<std::size_t>(j)];
      q[j] = std::uniform_real_distribution<double>(joint.lower, joint.upper)(random);
    }
    poses.push_back(tcp_pose(robot, q));
  }
  return poses;
}

bool is_among(const test::UrClosedForm::Angles& wanted, const std::vector<JointVector>& branches) {
  for (const JointVector& q : branches) {
    double distance = 0;
    for (std::size_t j = 0; j < 6; ++j)
      distance = std::max(
          distance, std::abs(std::remainder(wanted[j] - q[static_cast<Eigen::Index>(j)], 2 * kPi)));
    if (distance < 1e-4) return true;
  }
  return false;
}

void numeric(benchmark::State& state, const std::shared_ptr<const Robot>& robot,
             const test::UrClosedForm* closed_form) {
  const NumericInverseKinematics solver(robot);
  const std::vector<Pose> poses = poses_inside_limits(*robot, kNumericPoses);
  solve_all(state, poses, solver);
  std::vector<JointVector> branches, postures;
  double solved = 0, known = 0, found = 0, complete = 0;
  for (const Pose& pose : poses) {
    solver.solve(pose, branches);
    postures.clear();
    for (const JointVector& branch : branches) append_turns(*robot, branch, Turns::all, postures);
    if (!postures.empty()) ++solved;
    if (closed_form == nullptr) continue;
    double here = 0;
    const auto all = closed_form->solve(pose);
    for (const auto& wanted : all) here += is_among(wanted, branches) ? 1 : 0;
    known += static_cast<double>(all.size());
    found += here;
    if (here == static_cast<double>(all.size())) ++complete;
  }
  state.counters["solved_percent"] = 100 * solved / kNumericPoses;
  if (closed_form == nullptr) return;
  state.counters["of_all_solutions_percent"] = 100 * found / known;
  state.counters["poses_with_all_percent"] = 100 * complete / kNumericPoses;
}

const test::UrClosedForm ur5e_form = test::ur5e_closed_form(),
                         ur10e_form = test::ur10e_closed_form();
BENCHMARK_CAPTURE(numeric, ur5e, test::ur5e(), &ur5e_form)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(numeric, ur10e, test::ur10e(), &ur10e_form)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(numeric, iiwa14, test::iiwa14(), nullptr)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(numeric, planar_3r, test::planar_3r(), nullptr)->Unit(benchmark::kMillisecond);

/// 2 cm and 0.1 rad each way about a random pose, the spin free.
void numeric_box(benchmark::State& state, const std::shared_ptr<const Robot>& robot) {
  const NumericInverseKinematics solver(robot);
  const std::vector<Pose> poses = poses_inside_limits(*robot, 200);
  ToleranceBox box;
  box.upper << 0.02, 0.02, 0.02, 0.1, 0.1, ToleranceBox::kFree;
  box.lower = -box.upper;
  std::vector<JointVector> postures;
  double solved = 0, total = 0;
  while (state.KeepRunning()) {
    solved = total = 0;
    for (const Pose& pose : poses) {
      solver.solve_in_box(box, pose, postures);
      solved += postures.empty() ? 0 : 1;
      total += static_cast<double>(postures.size());
    }
  }
  const auto count = static_cast<double>(poses.size());
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(poses.size()));
  state.counters["solved_percent"] = 100 * solved / count;
  state.counters["postures_per_box"] = total / count;
}
BENCHMARK_CAPTURE(numeric_box, ur5e, test::ur5e())->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(numeric_box, iiwa14, test::iiwa14())->Unit(benchmark::kMillisecond);

/// One start, up to 0.5 rad in each joint from a posture in the box: how it is led there, and how
/// often it gets there.
enum class Way { damped_least_squares, slsqp };

void one_start(benchmark::State& state, const std::shared_ptr<const Robot>& robot, Way way,
               double half_width) {
  constexpr int kStarts = 400;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> off(-0.5, 0.5);
  std::vector<DeviationCell> cells;
  std::vector<JointVector> starts;
  for (int i = 0; i < kStarts; ++i) {
    JointVector q(robot->joint_count());
    for (int j = 0; j < robot->joint_count(); ++j) {
      const Joint& joint = robot->joints()[static_cast<std::size_t>(j)];
      q[j] = std::uniform_real_distribution<double>(joint.lower, joint.upper)(random);
    }
    ToleranceBox box;
    box.upper.setConstant(half_width);
    box.lower = -box.upper;
    cells.push_back(DeviationCell::of(box, tcp_pose(*robot, q)));
    for (double& value : q) value += off(random);
    starts.push_back(q.cwiseMax(robot->lower_limits()).cwiseMin(robot->upper_limits()));
  }
  const DescentRules rules{0.5, 1e-10, robot->lower_limits(), robot->upper_limits()};
  double reached = 0;
  while (state.KeepRunning()) {
    reached = 0;
    for (std::size_t i = 0; i < kStarts; ++i) {
      JointVector q = starts[i];
      const bool there = way == Way::slsqp ? move_to_nearest_in_cell(*robot, cells[i], rules.lower,
                                                                     rules.upper, q) &&
                                                 polish_in_cell(*robot, cells[i], rules, q)
                                           : descend_to_pose(*robot, cells[i].path_frame, rules, q);
      reached += there ? 1 : 0;
    }
  }
  state.SetItemsProcessed(state.iterations() * kStarts);
  state.counters["reached_percent"] = 100 * reached / kStarts;
}
BENCHMARK_CAPTURE(one_start, ur5e_pose_by_damped_least_squares, test::ur5e(),
                  Way::damped_least_squares, 0);
BENCHMARK_CAPTURE(one_start, ur5e_pose_by_slsqp, test::ur5e(), Way::slsqp, 0);
BENCHMARK_CAPTURE(one_start, ur5e_box_by_slsqp, test::ur5e(), Way::slsqp, 0.02);
BENCHMARK_CAPTURE(one_start, iiwa14_pose_by_damped_least_squares, test::iiwa14(),
                  Way::damped_least_squares, 0);
BENCHMARK_CAPTURE(one_start, iiwa14_pose_by_slsqp, test::iiwa14(), Way::slsqp, 0);
BENCHMARK_CAPTURE(one_start, iiwa14_box_by_slsqp, test::iiwa14(), Way::slsqp, 0.02);

void numeric_table(benchmark::State& state) {
  const auto robot = test::ur5e();
  while (state.KeepRunning()) {
    const NumericInverseKinematics solver(robot);
    benchmark::DoNotOptimize(&solver);
  }
}
BENCHMARK(numeric_table)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace wristwise
