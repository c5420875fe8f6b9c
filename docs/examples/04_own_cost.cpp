// A cost of your own, in both stages. Here: the hose of the torch should not wind up, so the spin,
// the turn of the torch about its own axis, is to stay near nominal although the seam leaves it
// free.
//
// The two stages take a cost in two forms. Stage 1 compares postures: it wants a number for a
// posture at a waypoint, in rad of joint motion. Stage 2 follows slopes: it wants a residual r of
// time and posture with its gradient, and minimises the integral of r^2 over time.

#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <wristwise/wristwise.hpp>

namespace {

constexpr double kDegree = 0.017453292519943295;
constexpr double kWeight = 0.02;  // rad of joint motion per rad of spin at a waypoint
constexpr double kRate = 0.2;     // rad/s per rad of spin

/// Twice the sine of half the spin: about the spin where that is small, and without a jump where it
/// passes 180 deg.
double chord(double spin) { return 2 * std::sin(spin / 2); }

/// How the TCP at q deviates from a frame of the seam: x, y, z (m), rx, ry, rz (rad). The last is
/// the spin.
double spin_at(const wristwise::Robot& robot, const wristwise::ToleranceBox& box,
               const wristwise::Pose& frame, const wristwise::JointVector& q) {
  return deviation(box, frame, tcp_pose(robot, q))[5];
}

/// Stage 1. It is called from several threads, so that it must not change anything.
void add_to_stage_1(wristwise::Problem& problem) {
  problem.cost.vertex_cost = [robot = problem.robot, waypoints = problem.task.waypoints](
                                 std::size_t i, const wristwise::JointVector& q) {
    const wristwise::Waypoint& waypoint = waypoints[i];
    return kWeight * std::abs(chord(spin_at(*robot, waypoint.tolerance, waypoint.frame, q)));
  };
}

/// Stage 2. The gradient of the deviation comes from the geometric Jacobian; that of a cost of the
/// joints alone is written down at once.
void add_to_stage_2(wristwise::Problem& problem) {
  problem.cost.posture_residuals.push_back(
      [robot = problem.robot, seam = problem.task.seam,
       box = problem.task.waypoints.front().tolerance](double t, const wristwise::JointVector& q,
                                                       wristwise::JointVector* gradient) {
        const wristwise::Pose frame = seam.frame_at(t);
        wristwise::ChainPose chain;
        forward_kinematics(*robot, q, chain);
        const double spin = deviation(box, frame, chain.tcp)[5];
        if (gradient != nullptr) {
          const wristwise::Jacobian slopes =
              deviation_jacobian(box, frame, chain.tcp, geometric_jacobian(*robot, chain));
          *gradient = kRate * std::cos(spin / 2) * slopes.row(5).transpose();
        }
        return kRate * chord(spin);
      });
}

double mean_spin_in_degrees(const wristwise::Problem& problem, const wristwise::JointPath& path) {
  double sum = 0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const wristwise::Pose frame = problem.task.seam.frame_at(path.times[i]);
    const auto& box = problem.task.waypoints.front().tolerance;
    sum += std::abs(spin_at(*problem.robot, box, frame, path.positions[i]));
  }
  return sum / static_cast<double>(path.size()) / kDegree;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc != 3) throw wristwise::InvalidInput("usage", "PROBLEM.yaml FOLDER");
    wristwise::Problem problem = wristwise::load_problem(argv[1]);
    if (!problem.task.waypoints.front().tolerance.is_free(5))
      throw wristwise::InvalidInput(argv[1], "the spin is not free",
                                    "`rz: free` in path.tolerance");

    const wristwise::PlanResult without = wristwise::plan(problem);
    add_to_stage_1(problem);
    add_to_stage_2(problem);
    const wristwise::PlanResult with = wristwise::plan(problem);
    for (const auto& diagnosis : with.diagnosis) std::cout << diagnosis.detail << '\n';
    if (without.trajectory.empty() || with.trajectory.empty()) return 1;

    std::cout << "mean spin without " << mean_spin_in_degrees(problem, without.path)
              << " deg, with " << mean_spin_in_degrees(problem, with.path) << " deg\n"
              << "cost of stage 1: " << with.seeds.front().cost << '\n';
    for (const wristwise::CostTerm& term : with.refine.terms)
      if (term.name == "own") std::cout << "own term of stage 2: " << term.final << '\n';

    const std::filesystem::path folder = argv[2];
    const auto names = problem.robot->joint_names();
    write_path(folder / "stage_1.csv", names, with.seeds.front().path);
    write_trajectory(folder / "stage_2.csv", names, with.trajectory);
    return with.status == wristwise::Status::solved ? 0 : 1;
  } catch (const wristwise::InvalidInput& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
