// The first stage by itself: what a planner in the manner of Descartes gives.
//
// Each waypoint of the seam becomes a rung: all postures that hold the torch inside the tolerance,
// on a grid. The ladder graph joins neighbouring rungs, and the cheapest way through it is the
// path. It is a list of points, joined by straight joint-space moves; it has no velocities.

#include <algorithm>
#include <iostream>
#include <wristwise/wristwise.hpp>

int main(int argc, char** argv) {
  try {
    if (argc != 3) throw wristwise::InvalidInput("usage", "PROBLEM.yaml PATH.csv");
    wristwise::Problem problem = wristwise::load_problem(argv[1]);

    // What the file says may be changed before planning. Here: all postures that differ by whole
    // turns, not only those in (-180, 180] deg, and no second try with a wider tolerance.
    problem.graph.turns = wristwise::Turns::all;
    problem.graph.try_relaxations = false;

    const wristwise::PlanResult result = wristwise::plan_graph_only(problem);
    for (const auto& diagnosis : result.diagnosis) std::cout << diagnosis.detail << '\n';
    if (result.path.times.empty()) return 1;

    // The cost is the sum of all joint steps, here in rad, unless `problem.cost` says otherwise.
    std::cout << result.inverse_kinematics << '\n'
              << result.graph.vertices << " vertices, " << result.graph.edges << " edges\n"
              << "cost " << result.graph.cost << '\n';

    // What the steps of the grid mean for the robot.
    const wristwise::JointVector limits = problem.robot->velocity_limits();
    double ratio = 0;
    for (const wristwise::JointVector& rate : divided_differences(result.path, 1))
      ratio = std::max(ratio, rate.cwiseAbs().cwiseQuotient(limits).maxCoeff());
    std::cout << "joint speed up to " << 100 * ratio << "% of its limit\n"
              << (result.verification.passed ? "check passed\n" : "check failed\n");

    write_path(argv[2], problem.robot->joint_names(), result.path);
    return result.status == wristwise::Status::solved ? 0 : 1;
  } catch (const wristwise::InvalidInput& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
